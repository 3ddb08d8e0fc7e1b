#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Orders each cut (Cut::after) after all cuts that lie inside its outline, of any part, and those
/// on a line, open ones that reach into it, too: it frees the material around them. Of several
/// loops of one contour the largest is the last.
/// @param outlines by contour
void put_parts_last(const drawing::Drawing& drawn,
                    const std::vector<Outline>& outlines,
                    std::vector<Cut>& cuts);

/// Returns the outermost contour around a contour that is cut beside its line; itself where none
/// is.
[[nodiscard]] std::size_t part_of(const drawing::Drawing& drawn,
                                  const std::vector<Outline>& outlines,
                                  std::size_t contour);

}  // namespace sim::cut

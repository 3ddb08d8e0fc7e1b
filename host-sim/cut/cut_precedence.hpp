#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Sets Cut::after so that each cut comes after all cuts that lie inside its outline, because it
/// frees the material around them. These may belong to any part. Cuts on a line count, too, also
/// open ones that reach into the outline. Of several loops of one contour the largest is the last.
/// @param outlines by contour
void put_parts_last(const drawing::Drawing& drawn,
                    const std::vector<Outline>& outlines,
                    std::vector<Cut>& cuts);

/// Returns the outermost contour around a contour that is cut next to its line. Returns the contour
/// itself if no contour is around it.
[[nodiscard]] std::size_t part_of(const drawing::Drawing& drawn,
                                  const std::vector<Outline>& outlines,
                                  std::size_t contour);

}  // namespace sim::cut

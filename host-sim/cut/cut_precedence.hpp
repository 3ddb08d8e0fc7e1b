#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Sets Cut::after so that each cut comes after all cuts inside its outline, because it frees the
/// material around them. The inner cuts may belong to any part. They include cuts on a line, also
/// open lines that are only partly inside. Of several loops of one contour, the largest is cut
/// last.
/// @param outlines outline of each contour
void put_parts_last(const drawing::Drawing& drawn,
                    const std::vector<Outline>& outlines,
                    std::vector<Cut>& cuts);

/// Returns the outermost of the contours around a contour that are cut next to their lines. If
/// there is none, returns the contour itself.
[[nodiscard]] std::size_t part_of(const drawing::Drawing& drawn,
                                  const std::vector<Outline>& outlines,
                                  std::size_t contour);

}  // namespace sim::cut

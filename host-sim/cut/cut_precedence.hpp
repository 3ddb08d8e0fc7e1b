#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Sets Cut::after so that each cut comes after all cuts inside its outline, because the outer cut
/// frees the material of the inner cuts. The inner cuts may belong to any part. They include cuts
/// on a line, also open lines that are only partly inside. Of several loops of one contour, the
/// largest is cut last.
/// @param outlines outline of each contour
void put_parts_last(const drawing::Drawing& drawn,
                    const std::vector<Outline>& outlines,
                    std::vector<Cut>& cuts);

/// Returns the part of a contour: of the contours around it that are cut next to their lines, the
/// outermost one. If there is none, returns the contour itself.
[[nodiscard]] std::size_t part_of(const drawing::Drawing& drawn,
                                  const std::vector<Outline>& outlines,
                                  std::size_t contour);

}  // namespace sim::cut

#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Returns the waste on the right of outlines, on the left of contours which may touch. Outlines
/// that turn back by a hair are read by the filling rule; see filled_area().
/// Throws NoOffset where waste does not close, or outlines overlap by more than a hair.
/// @param rows closed outlines with parts on their left, one at least
/// @param is_in_holes the outermost of them are holes; else waste ends at a frame far around them
[[nodiscard]] Contour waste_beside(const std::vector<const std::vector<Stroke>*>& rows,
                                   bool is_in_holes);

}  // namespace sim::cut

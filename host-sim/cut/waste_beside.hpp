#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Returns the waste on the right of outlines, as contours that have the waste on their left and
/// may touch. The filling rule decides about outlines that turn back on themselves by no more than
/// rounding; see filled_area(). Throws NoOffset if the contours of the waste do not close, or if
/// outlines overlap by more than rounding.
/// @param rows closed outlines with parts on their left, at least one
/// @param is_in_holes whether the outermost outlines are holes; otherwise the waste ends at a frame
/// far around the outlines
[[nodiscard]] Contour waste_beside(const std::vector<const std::vector<Stroke>*>& rows,
                                   bool is_in_holes);

}  // namespace sim::cut

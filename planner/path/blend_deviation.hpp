#pragma once

#include "planner/path/corner.hpp"

namespace cnc::path {

/// Returns the greatest distance in mm between the path at a corner and its biarc with this trim.
/// The distance is measured both from the path to the biarc and from the biarc to the path. It is
/// computed from samples, with an allowance for the distances between them. So the result is never
/// too small, and at most 3 % too large. If there is no such biarc, the result is 1e9.
/// @pre legs turn by at most half a radian within the trim
[[nodiscard]] float blend_deviation(const Corner& corner, float trim_mm);

}  // namespace cnc::path

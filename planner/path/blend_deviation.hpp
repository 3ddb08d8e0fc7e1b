#pragma once

#include "planner/path/corner.hpp"

namespace cnc::path {

/// Returns the greatest distance between a corner and the biarc for this trim, mm, measured from
/// either to the other in the plane. It is computed from samples, plus an allowance for what
/// samples may miss: never too small, and up to 3 % too large.
/// Very large where there is no such biarc.
/// @pre legs turn by at most half a radian within the trim
[[nodiscard]] float blend_deviation(const Corner& corner, float trim_mm);

}  // namespace cnc::path

#pragma once

#include "planner/path/corner.hpp"

namespace cnc::path {

/// How far apart a corner and the biarc for this trim are at most, mm, measured
/// from either to the other in the plane. From samples, with what these may
/// have missed added: never too small, up to 3 % too large.
/// Very large where there is no such biarc.
/// @pre legs turn by at most half a radian within the trim
[[nodiscard]] float blend_deviation(const Corner& corner, float trim_mm);

}  // namespace cnc::path

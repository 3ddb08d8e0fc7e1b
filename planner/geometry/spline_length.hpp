#pragma once

#include "planner/geometry/spline.hpp"

namespace cnc {

/// Returns the length of the curve in mm, within 3 in 1000. This is precise enough for durations,
/// but not for positions.
[[nodiscard]] float length_of(const Spline& spline);

}  // namespace cnc

#pragma once

#include "planner/geometry/spline.hpp"

namespace cnc {

/// Along the curve, mm, within 3 in 1000: for durations, not for places.
[[nodiscard]] float length_of(const Spline& spline);

}  // namespace cnc

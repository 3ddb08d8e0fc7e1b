#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/wall/beam.hpp"

namespace sim::wall {

inline constexpr double kDegree = std::numbers::pi / 180.0;

/// Returns the angle of a beam's axis from Z, radians.
inline double tilt_of(const cnc::wall::Beam& beam) {
  return std::acos(std::min(1.0, beam.axis.z()));
}

}  // namespace sim::wall

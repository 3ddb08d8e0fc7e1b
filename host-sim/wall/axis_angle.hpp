#pragma once

#include <Eigen/Geometry>

#include "planner/base/wide_scalar_math.hpp"

namespace sim::wall {

/// Returns the angle between two unit vectors, 0 to π radians.
[[nodiscard]] inline double angle_between(const Eigen::Vector3d& one,
                                          const Eigen::Vector3d& other) {
  return cnc::wide_atan2(one.cross(other).norm(), one.dot(other));
}

}  // namespace sim::wall

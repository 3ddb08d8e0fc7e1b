#include "host-sim/surface/approach.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace sim::surface {

Eigen::Matrix3d turn_for_approach(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d up = -direction.normalized();
  constexpr double kAlongAxis = 1.0e-12;
  if (up.head<2>().norm() < kAlongAxis) {
    if (up.z() > 0.0) return Eigen::Matrix3d::Identity();
    return Eigen::Vector3d{1.0, -1.0, -1.0}.asDiagonal();
  }
  const Eigen::Quaterniond shortest =
      Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ());
  Eigen::Matrix3d turn = shortest.toRotationMatrix();
  for (double& part : turn.reshaped()) {
    const double whole = std::round(part);
    if (std::abs(part - whole) < kAlongAxis) part = whole;
  }
  return turn;
}

}  // namespace sim::surface

#pragma once

#include <Eigen/Core>

namespace sim::surface {

/// A straight line in plan, over which a path follows the heights of a surface; mm.
struct Slice {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< Unit vector of the line's direction.
  double length = 0.0;

  [[nodiscard]] Eigen::Vector2d at(double along) const { return from + along * direction; }
};

/// Returns the slice between two points.
/// @pre the points differ
[[nodiscard]] inline Slice slice_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const double length = (to - from).norm();
  return {.from = from, .direction = (to - from) / length, .length = length};
}

}  // namespace sim::surface

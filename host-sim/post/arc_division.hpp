#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/base/axes.hpp"

namespace sim::post {

/// An arc or a helix of a program, mm.
struct ProgramArc {
  cnc::Plane plane = cnc::Plane::kXY;
  bool is_clockwise = false;
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  /// Centre; its coordinate along the normal is that of `from`.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();

  /// Returns the angle of the arc's turn, above 0 and at most a full turn. It is a full turn if the
  /// arc ends at its start.
  [[nodiscard]] double sweep() const;
  /// Returns the mean of the arc's radii at its start and end.
  [[nodiscard]] double radius() const;
};

/// Returns the points that divide an arc into equal parts, and its end. The last point is exactly
/// `to`.
/// @pre parts is above 0
[[nodiscard]] std::vector<Eigen::Vector3d> divided(const ProgramArc& arc, int parts);

/// Returns the number of chords that leave an arc by no more than a tolerance.
/// @param tolerance_mm above 0
[[nodiscard]] int chords_within(const ProgramArc& arc, double tolerance_mm);

}  // namespace sim::post

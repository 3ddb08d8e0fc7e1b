#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/base/axes.hpp"

namespace sim::post {

/// An arc or a helix of a program. Points are in mm.
struct ProgramArc {
  cnc::Plane plane = cnc::Plane::kXY;
  bool is_clockwise = false;
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  /// Centre. Its coordinate along the normal of the plane is that of `from`.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();

  /// Returns the angle through which the arc turns, radians, above 0 and at most a full turn. It is
  /// a full turn if the arc ends at its start.
  [[nodiscard]] double sweep() const;
  /// Returns the mean of the radii at the start and at the end of the arc, mm.
  [[nodiscard]] double radius() const;
};

/// Returns the points that divide an arc into `parts` equal parts, without its start. The last
/// point is exactly `to`.
/// @pre parts is above 0
[[nodiscard]] std::vector<Eigen::Vector3d> divided(const ProgramArc& arc, int parts);

/// Returns a number of equal chords that deviate from an arc by at most `tolerance_mm`.
/// @param tolerance_mm above 0
[[nodiscard]] int chords_within(const ProgramArc& arc, double tolerance_mm);

}  // namespace sim::post

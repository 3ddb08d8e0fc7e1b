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
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< Along the normal as `from`.

  /// Returns the angle through which it turns, above 0 and at most a full turn; a full turn where
  /// it ends where it began.
  [[nodiscard]] double sweep() const;
  /// Returns the mean of its radii at both ends.
  [[nodiscard]] double radius() const;
};

/// Returns the points between equal parts of an arc, its end included; the last one is `to` itself.
/// @pre parts is above 0
[[nodiscard]] std::vector<Eigen::Vector3d> divided(const ProgramArc& arc, int parts);

/// Returns how many chords leave an arc by no more than a tolerance, above 0, mm.
[[nodiscard]] int chords_within(const ProgramArc& arc, double tolerance_mm);

}  // namespace sim::post

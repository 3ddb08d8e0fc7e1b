#pragma once

#include <vector>

#include "host-sim/machine/five_axis_model.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim::joints {

/// Straight moves of the axes of a five-axis machine that together move the tip along a curve.
struct JointWay {
  /// Axis positions, mm and degrees, at the ends of equal parts of the curve.
  std::vector<Point> ends;
  /// Greatest measured distance between the tip and its intended point on the curve.
  double error_mm = 0.0;
};

/// Computes moves of all axes, each over an equal part of the curve. Increases the number of moves
/// until the tip stays within the tolerance of its intended point.
/// @param curve motion of a program with G43.4, mm and degrees
/// @param tolerance_mm greatest deviation of the tip, > 0
/// Throws std::invalid_argument if a million moves are too few.
[[nodiscard]] JointWay joint_way(const FiveAxisModel& model,
                                 const Curve& curve,
                                 double tolerance_mm);

}  // namespace sim::joints

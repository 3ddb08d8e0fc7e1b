#pragma once

#include <vector>

#include "host-sim/machine/five_axis_model.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim::joints {

/// Straight moves of all axes of a five-axis machine that carry the tip along a curve.
struct JointWay {
  std::vector<Point> ends;  ///< Axis positions, mm and degrees, at equal shares of the curve.
  /// Greatest distance found between the tip and its intended point on the curve.
  double error_mm = 0.0;
};

/// Returns the moves of all axes over equal shares of the curve. Their count is the smallest that
/// keeps the tip within a tolerance of its intended point.
/// @param curve positions of a program under G43.4, mm and degrees
/// @param tolerance_mm tolerance of the tip, above 0
/// Throws std::invalid_argument if a million moves are too few.
[[nodiscard]] JointWay joint_way(const FiveAxisModel& model,
                                 const Curve& curve,
                                 double tolerance_mm);

}  // namespace sim::joints

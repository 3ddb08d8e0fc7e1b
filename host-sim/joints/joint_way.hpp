#pragma once

#include <vector>

#include "host-sim/machine/five_axis_model.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim::joints {

/// Straight moves of all axes of a five-axis machine that carry the tip along a curve.
struct JointWay {
  std::vector<Point> ends;  ///< Places of the axes, mm and degrees, at equal shares of the curve.
  double error_mm = 0.0;    ///< Greatest distance found between the tip and its place on the curve.
};

/// Returns as few moves of equal shares as keep the tip within a tolerance of its place.
/// @param curve places of a program under G43.4, mm and degrees
/// @param tolerance_mm above 0
/// Throws std::invalid_argument where a million moves are too few.
[[nodiscard]] JointWay joint_way(const FiveAxisModel& model,
                                 const Curve& curve,
                                 double tolerance_mm);

}  // namespace sim::joints

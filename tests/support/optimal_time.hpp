#pragma once

#include <limits>
#include <vector>

#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// What the machine can do; mm and seconds, degrees for A, B and C.
struct MotionLimits {
  cnc::AxisArray<double> rate{};          ///< mm/s.
  cnc::AxisArray<double> acceleration{};  ///< mm/s².
  /// Of all motors together, steps/s; needs steps_per_mm.
  double step_rate = std::numeric_limits<double>::infinity();
  cnc::AxisArray<double> steps_per_mm{};
};

/// Speed over the six-axis length of the path. Acceleration is constant from
/// one sample to the next.
struct SpeedProfile {
  struct Sample {
    double place = 0.0;  ///< mm from the start of the path.
    double speed = 0.0;  ///< mm/s.
    Point tangent{};     ///< Unit.
    Point curvature{};   ///< 1/mm.
  };
  std::vector<Sample> samples;  ///< Two at each joint.

  [[nodiscard]] double seconds() const;
};

/// The fastest motion along a path with limited acceleration (not jerk): the
/// reference for the product's job times. Independent of the product's planner.
///
/// With u = v² and u' = 2a, the rules for each axis, |t a + t' u| ≤ A with the
/// curve's tangent t and its derivative t', are linear in u. A backward pass
/// finds the greatest u from which the rest can be travelled, a forward pass the
/// greatest u that can be reached (Pham and Pham, TOPP-RA, 2018). Arcs also keep
/// v²/R within the lesser acceleration of the two axes of their plane.
/// It stands still at both ends, where the path turns, and before pieces marked stop_before.
///
/// Accuracy: at most 0.02 mm and 0.5 degrees between samples, closer at the ends of a
/// piece, but never more than 4000 of them on one; errors below 1e-4 of the time of a
/// move that speeds up and slows down (optimal_time_test).
[[nodiscard]] SpeedProfile optimal_profile(const ProgrammedPath& path, const MotionLimits& limits);

[[nodiscard]] double optimal_time(const ProgrammedPath& path, const MotionLimits& limits);

}  // namespace sim

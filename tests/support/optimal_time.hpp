#pragma once

#include <limits>
#include <vector>

#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// The same limit for every axis.
[[nodiscard]] constexpr cnc::AxisArray<double> every_axis(double limit) {
  return {limit, limit, limit, limit, limit, limit};
}

/// What the machine can do; mm and seconds, degrees for A, B and C.
struct MotionLimits {
  cnc::AxisArray<double> rate{};          ///< mm/s.
  cnc::AxisArray<double> acceleration{};  ///< mm/s².
  /// mm/s³, $800…; not for optimal_profile, which knows no jerk.
  cnc::AxisArray<double> jerk = every_axis(std::numeric_limits<double>::infinity());
  /// Of all motors together, steps/s; needs steps_per_mm.
  double step_rate = std::numeric_limits<double>::infinity();
  cnc::AxisArray<double> steps_per_mm{};
};

/// Whether the joint before a piece is taken at rest, with these unit tangents on
/// its sides.
[[nodiscard]] bool is_stop(const PathPiece& piece, const Point& leaving, const Point& entering);

/// The square of the greatest speed at a place of a piece: feed, rates of the axes, step rate
/// and v²/R. Tangent and curvature are those of the place.
[[nodiscard]] double speed_limit_squared(const PathPiece& piece,
                                         const Point& tangent,
                                         const Point& curvature,
                                         const MotionLimits& limits);

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
/// greatest u that can be reached (Pham and Pham, TOPP-RA, 2018). On arcs each axis
/// keeps its share of v²/R alone, a = 0, within its limit, too.
/// It stands still at both ends, where the path turns, and before pieces marked stop_before.
///
/// Accuracy: at most 0.02 mm and 0.5 degrees between samples, closer at the ends of a
/// piece, but never more than 4000 of them on one; errors below 1e-4 of the time of a
/// move that speeds up and slows down (optimal_time_test).
[[nodiscard]] SpeedProfile optimal_profile(const ProgrammedPath& path, const MotionLimits& limits);

[[nodiscard]] double optimal_time(const ProgrammedPath& path, const MotionLimits& limits);

}  // namespace sim

#pragma once

#include <limits>
#include <vector>

#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// Returns the same limit for every axis.
[[nodiscard]] constexpr cnc::AxisArray<double> every_axis(double limit) {
  return {limit, limit, limit, limit, limit, limit};
}

/// Limits of the machine, in mm and seconds; degrees for A, B and C.
struct MotionLimits {
  cnc::AxisArray<double> rate{};          ///< Greatest speeds, mm/s.
  cnc::AxisArray<double> acceleration{};  ///< Greatest accelerations, mm/s².
  /// Greatest jerks, mm/s³ ($800…). optimal_profile ignores them.
  cnc::AxisArray<double> jerk = every_axis(std::numeric_limits<double>::infinity());
  /// Greatest step rate of all motors together, steps/s; requires steps_per_mm.
  double step_rate = std::numeric_limits<double>::infinity();
  cnc::AxisArray<double> steps_per_mm{};
};

/// Returns whether the motion must be at rest at the joint before `piece`. The unit tangents are
/// those at the end of the piece before (`leaving`) and at the start of `piece` (`entering`).
[[nodiscard]] bool is_stop(const PathPiece& piece, const Point& leaving, const Point& entering);

/// Returns the square of the greatest speed at a point of a piece by feed, rates of the axes, step
/// rate and v²/R. `tangent` and `curvature` are those at the point.
[[nodiscard]] double speed_limit_squared(const PathPiece& piece,
                                         const Point& tangent,
                                         const Point& curvature,
                                         const MotionLimits& limits);

/// Speed over the length of the path in all six axes. Acceleration is constant from one sample to
/// the next.
struct SpeedProfile {
  struct Sample {
    double place = 0.0;  ///< Position along the path, mm.
    double speed = 0.0;  ///< Speed, mm/s.
    Point tangent{};     ///< Unit tangent.
    Point curvature{};   ///< Curvature vector, 1/mm.
  };
  std::vector<Sample> samples;  ///< Samples in order of the path; each joint has two.

  [[nodiscard]] double seconds() const;
};

/// Computes the fastest motion along a path with limited acceleration (not jerk): the reference for
/// the product's job times. It is independent of the product's planner.
///
/// With u = v² and u' = 2a, the rules for each axis, |t a + t' u| ≤ A with the curve's tangent t
/// and its derivative t', are linear in u. A backward pass finds the greatest u from which the rest
/// of the path can be driven. A forward pass finds the greatest u that can be reached (Pham and
/// Pham, TOPP-RA, 2018). On arcs each axis also keeps its share of v²/R alone (a = 0) within its
/// limit. The motion is at rest at both ends, at corners, and before pieces marked stop_before.
///
/// Accuracy: samples are at most 0.02 mm and 0.5 degrees apart, and closer at the ends of a piece,
/// but a piece has at most 4000 of them. For a move that speeds up and slows down, the error of the
/// time is below 1e-4 (optimal_time_test).
[[nodiscard]] SpeedProfile optimal_profile(const ProgrammedPath& path, const MotionLimits& limits);

[[nodiscard]] double optimal_time(const ProgrammedPath& path, const MotionLimits& limits);

}  // namespace sim

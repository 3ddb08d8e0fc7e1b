#pragma once

#include <vector>

#include "tests/support/speed_mesh.hpp"

namespace sim {

/// The time of the fastest motion along a path with limited rate, acceleration and jerk of every
/// axis, enclosed from both sides.
struct JerkLimitedTime {
  /// s, of a motion that keeps every rule on the grid: a local optimum.
  double found = 0.0;
  /// s; no motion that keeps the rules is faster, but for the error of the grid.
  double bound = 0.0;
  std::size_t cells = 0;
};

/// The fastest motion along the exact path with full knowledge of it. At joints of pieces
/// the speed and the acceleration along the path are continuous; the normal acceleration
/// may step there, and the direction may, at the speed of the corner rule. Arcs
/// keep v²/R as in optimal_profile. Standstill is at both ends, before pieces marked
/// stop_before and at corners whose rule is below 1 µm/s.
///
/// With y = v³ over the path as a quadratic spline, all rules but one side of the jerk's
/// are convex (speed_rules.hpp). `found` follows a logarithmic barrier (Boyd and
/// Vandenberghe, Convex Optimization, 2004, chapter 11) with the jerk as it is. `bound` puts upper
/// bounds of a²/v in the place of a²/v where the rule is not convex: a convex problem
/// that every motion fits in, solved to a known duality gap, which is taken off.
///
/// Error of the grid, for both: 0…0.3 % above the closed form on straight moves; within 0.5 % of
/// a grid three times as fine on chains of lines and arcs (jerk_time_test), 0.8 % where jerk
/// more than doubles the time.
///
/// `found` is the optimum as far as is known: searches from very different motions meet
/// within 1e-4 on 243 of 250 random programs, within 0.8 % on all, and an optimum found by
/// hand comes out (faster_feed_test). `bound` is certain, but lower by up to a third of
/// what the jerk limit costs: with 5 ms to full acceleration 0.1 % in the median of random
/// programs and 1.8 % in nine of ten, with 20 ms 0.5 % and 5 %. So ratios belong to
/// `found`, and a plan that beats `bound` by more than the grid's error breaks a limit.
[[nodiscard]] JerkLimitedTime jerk_limited_time(const ProgrammedPath& path,
                                                const MotionLimits& limits,
                                                const MeshSize& size = {});

/// Speed and acceleration along the path at the ends of the cells of the motion found.
struct JerkSample {
  double place = 0.0;         ///< mm.
  double speed = 0.0;         ///< mm/s.
  double acceleration = 0.0;  ///< mm/s².
};
[[nodiscard]] std::vector<JerkSample> jerk_limited_profile(const ProgrammedPath& path,
                                                           const MotionLimits& limits,
                                                           const MeshSize& size = {});

}  // namespace sim

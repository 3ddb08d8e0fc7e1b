#pragma once

#include <vector>

#include "tests/support/speed_mesh.hpp"

namespace sim {

/// Time of the fastest motion along a path with limited rate, acceleration and jerk of every axis:
/// a value that a motion attains, and a lower bound.
struct JerkLimitedTime {
  /// Time of a motion that satisfies all rules on the grid, s. It is a local optimum.
  double found = 0.0;
  /// Lower bound of the time of all motions that satisfy the rules, s, except for the error of the
  /// grid.
  double bound = 0.0;
  std::size_t cells = 0;
};

/// Computes the fastest motion along the exact path with full knowledge of it. At joints of pieces
/// the speed and the acceleration along the path are continuous. The normal acceleration may step
/// there. The direction may step, too, at the speed of the corner rule. Arcs keep v²/R as in
/// optimal_profile. The motion is at rest at both ends, before pieces marked stop_before and at
/// corners whose rule gives less than 1 µm/s.
///
/// With y = v³ over the path as a quadratic spline, all rules except one side of the jerk rule are
/// convex (speed_rules.hpp). `found` results from a logarithmic barrier (Boyd and Vandenberghe,
/// Convex Optimization, 2004, chapter 11) with the exact jerk rule. `bound` uses upper bounds of
/// a²/v where the rule is not convex. This relaxed problem is convex and permits every valid
/// motion. It is solved to a known duality gap, which is subtracted.
///
/// Both results contain the error of the grid. jerk_time_test bounds it on straight moves, by the
/// closed form, and on chains of lines and arcs, by finer grids.
///
/// `found` is the optimum as far as is known: searches from very different motions agree
/// (jerk_time_test), and it includes an optimum that was found independently (faster_feed_test).
/// `bound` is certain, but lower by up to a third of the time that the jerk limit costs. So ratios
/// refer to `found`, and a plan that is faster than `bound` by more than the grid's error violates
/// a limit.
[[nodiscard]] JerkLimitedTime jerk_limited_time(const ProgrammedPath& path,
                                                const MotionLimits& limits,
                                                const MeshSize& size = {});

/// Speed and acceleration along the path at the end of a cell of the motion found.
struct JerkSample {
  double place = 0.0;         ///< Position along the path, mm.
  double speed = 0.0;         ///< Speed, mm/s.
  double acceleration = 0.0;  ///< Acceleration, mm/s².
};
[[nodiscard]] std::vector<JerkSample> jerk_limited_profile(const ProgrammedPath& path,
                                                           const MotionLimits& limits,
                                                           const MeshSize& size = {});

}  // namespace sim

#pragma once

#include <array>
#include <cstddef>

#include "tests/support/filtered_plan.hpp"
#include "tests/support/optimal_time.hpp"

namespace sim {

/// Greatest value of a figure, with the time, position, piece and axis at which it occurs.
struct WorstFigure {
  double value = 0.0;
  double time = 0.0;   ///< Time, s.
  double place = 0.0;  ///< Position along the path, mm.
  std::size_t piece = 0;
  std::size_t axis = 0;
};

/// Load of the axes by a motion along a path. Ratios are 1 at the limit.
struct MotionFigures {
  WorstFigure rate;          ///< Axis speed / limit.
  WorstFigure acceleration;  ///< |t a + t′ v²| / limit.
  WorstFigure jerk;          ///< |t j + 3 t′ v a + t″ v³| / limit.
  WorstFigure feed;          ///< Path speed / programmed feed.
  WorstFigure step;          ///< Step of t′ v² at a tangent joint / acceleration limit.
  WorstFigure turn;          ///< Step of t v at a joint, mm/s. No axis can follow such a step.
  WorstFigure stop;          ///< Path speed at a programmed stop, mm/s.
  FilteredPlan::Gap gap;     ///< Greatest difference between successive pieces of the plan itself.
  double end_error = 0.0;    ///< |end position − length of the path|, mm.
};

/// Evaluates a filtered plan on the exact path, in double precision. Samples are at every time at
/// which the jerk changes, before and after every joint, and 20,000 times a second between.
/// Derivatives are those of the curves (t, t′ and t″: the tangent and its derivatives by length).
/// So steps of the curvature at joints do not count as jerk, and are judged separately.
///
/// Between two samples a figure may be greater by its change within 25 µs: on arcs 1e-4 of the
/// limit at v/R = 1/s per 4 rad. On lines no greater value is possible.
[[nodiscard]] MotionFigures judge_motion(const FilteredPlan& plan,
                                         const ProgrammedPath& path,
                                         const MotionLimits& limits);

/// Returns t″, the change of the curvature vector per length, 1/mm²; zero on a line.
[[nodiscard]] Point curvature_rate_at(const Curve& curve, double fraction);

}  // namespace sim

#pragma once

#include <array>
#include <cstddef>

#include "tests/support/filtered_plan.hpp"
#include "tests/support/optimal_time.hpp"

namespace sim {

/// The greatest of many figures, and where and when it was.
struct WorstFigure {
  double value = 0.0;
  double time = 0.0;   ///< s.
  double place = 0.0;  ///< mm along the path.
  std::size_t piece = 0;
  std::size_t axis = 0;
};

/// What a motion along a path asks of the axes; ratios are 1 at the limit.
struct MotionFigures {
  WorstFigure rate;          ///< Axis speed / limit.
  WorstFigure acceleration;  ///< |t a + t′ v²| / limit.
  WorstFigure jerk;          ///< |t j + 3 t′ v a + t″ v³| / limit.
  WorstFigure feed;          ///< Path speed / programmed feed.
  WorstFigure step;          ///< Step of t′ v² at a joint / acceleration limit: tangent joints.
  WorstFigure turn;          ///< Step of t v at a joint, mm/s: what no axis can do.
  WorstFigure stop;          ///< Path speed where the path says stop, mm/s.
  FilteredPlan::Gap gap;     ///< Of the plan itself, from piece to piece.
  double end_error = 0.0;    ///< |place at the end − length of the path|, mm.
};

/// Evaluates a filtered plan on the exact path, in double precision: at every time at
/// which the jerk changes and at every joint, both from before and from after, and
/// 20,000 times a second between. Derivatives are those of the curves (t, t′ and t″: tangent and
/// its derivatives by length), so steps of the curvature at joints are no jerk; they
/// are judged by themselves.
///
/// Between two samples a figure may be greater by its own change in 25 µs: on arcs
/// 1e-4 of the limit at v/R = 1/s per 4 rad; on lines nothing is missed.
[[nodiscard]] MotionFigures judge_motion(const FilteredPlan& plan,
                                         const ProgrammedPath& path,
                                         const MotionLimits& limits);

/// t″: the change of the curvature vector per length, 1/mm²; zero on a line.
[[nodiscard]] Point curvature_rate_at(const Curve& curve, double fraction);

}  // namespace sim

#pragma once

#include "tests/simulation/plan_check.hpp"

namespace proof {

/// How well the step pulses follow the plan.
struct EdgeFigures {
  /// For each edge the least distance, in steps, between the half step that it
  /// stands for and the plan within 25 µs; without what geometry_slack allows.
  Greatest lateness;
  /// The same at the ends of slices, between motor and plan, beyond half a step.
  Greatest separation;
  std::size_t edges = 0;
  bool pulses_kept = true;     ///< Width of pulse and of pause, direction set-up time.
  bool final_position = true;  ///< round(target · steps/mm) of every axis.
};

/// What fixed point and single precision may add to half a step, in steps: a
/// fiftieth of a step, and on arcs 0.1 µm in 1 m of radius.
inline constexpr double kEdgeSlack = 0.02;

/// Plays the segments of a plan through the step generator and holds every
/// edge against the continuous plan.
[[nodiscard]] EdgeFigures check_edges(const RecordedPlan& plan, const TestMachine& machine);

}  // namespace proof

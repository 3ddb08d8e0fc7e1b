#pragma once

#include "tests/simulation/plan_check.hpp"

namespace proof {

/// Differences between the step pulses and the plan.
struct EdgeFigures {
  /// Greatest distance, in steps, between the half step of an edge and the plan within 25 µs,
  /// beyond geometry_slack.
  Greatest lateness;
  /// Greatest distance between motor and plan at the ends of slices, in steps, beyond half a step.
  Greatest separation;
  std::size_t edges = 0;
  /// Whether pulses, pauses and direction set-up had their minimum times.
  bool pulses_kept = true;
  bool final_position = true;  ///< Whether every axis ended at round(target · steps/mm).
};

/// Error that fixed point and single precision may add to half a step, in steps: a fiftieth of a
/// step, and on arcs 0.1 µm per 1 m of radius.
inline constexpr double kEdgeSlack = 0.02;

/// Plays the segments of a plan through the step generator and compares every edge with the
/// continuous plan.
[[nodiscard]] EdgeFigures check_edges(const RecordedPlan& plan, const TestMachine& machine);

}  // namespace proof

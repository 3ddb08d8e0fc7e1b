#pragma once

#include <vector>

#include "tests/support/filtered_plan.hpp"
#include "tests/support/optimal_time.hpp"
#include "tests/support/recorded_plan.hpp"

namespace proof {

/// A recorded plan in the form that motion_judge.hpp requires.
struct RecordedMotion {
  /// One piece per slice: position over time, before any filter.
  std::vector<sim::PlanPiece> pieces;
  sim::ProgrammedPath path;  ///< One piece per block, with the exact geometry.
};

/// Converts a recorded plan. Positions are the slices' fractions of the exact lengths, so that
/// rounding of the plan's lengths does not accumulate. FilteredPlan::greatest_gap shows this
/// rounding.
[[nodiscard]] RecordedMotion motion_of(const RecordedPlan& plan);

}  // namespace proof

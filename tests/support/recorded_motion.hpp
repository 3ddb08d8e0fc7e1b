#pragma once

#include <vector>

#include "tests/support/filtered_plan.hpp"
#include "tests/support/optimal_time.hpp"
#include "tests/support/recorded_plan.hpp"

namespace proof {

/// A recorded plan in the terms of its judge (motion_judge.hpp).
struct RecordedMotion {
  std::vector<sim::PlanPiece> pieces;  ///< A slice each: place over time, before any filter.
  sim::ProgrammedPath path;            ///< A piece for each block, of the exact geometry.
};

/// Places are the slices' fractions of the exact lengths, so that the rounding of the plan's
/// lengths does not add up; it shows in FilteredPlan::greatest_gap.
[[nodiscard]] RecordedMotion motion_of(const RecordedPlan& plan);

}  // namespace proof

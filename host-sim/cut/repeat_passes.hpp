#pragma once

#include "host-sim/cut/plan.hpp"
#include "host-sim/cut/safety.hpp"

namespace sim::cut {

/// Repeats each cut for the number of passes of its layer. Either each contour gets all its passes
/// before the next contour, or all neighbouring cuts of a layer get one pass before the next pass.
/// Open lines are driven to and fro. Each pass is a separate cut; see Cut::pass. Throws
/// std::invalid_argument if several passes are incompatible with the measures that made the plan
/// safe.
/// @param wishes the wishes with which make_safe() was called before
void repeat_passes(CutPlan& plan, const SafetyWishes& wishes);

}  // namespace sim::cut

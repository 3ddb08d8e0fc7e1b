#pragma once

#include "host-sim/cut/plan.hpp"
#include "host-sim/cut/safety.hpp"

namespace sim::cut {

/// Repeats cuts according to the number of passes of their layers: each contour before the next
/// one, or all neighbouring cuts of a layer once and then once more. Open lines are driven to and
/// fro. Each pass of a cut is a cut of its own, see Cut::pass. Throws std::invalid_argument if
/// passes are incompatible with the measures that made the plan safe.
/// @param wishes the wishes with which make_safe() was called before
void repeat_passes(CutPlan& plan, const SafetyWishes& wishes);

}  // namespace sim::cut

#pragma once

#include "host-sim/cut/plan.hpp"
#include "host-sim/cut/safety.hpp"

namespace sim::cut {

/// Repeats cuts as often as their layers want passes: each contour before the next one, or all
/// neighbouring cuts of a layer once and then once more. Open lines are driven to and fro. The
/// passes of a cut are cuts of their own, see Cut::pass. Throws std::invalid_argument where passes
/// do not go with what the plan was made safe by.
/// @param wishes by which make_safe() was called before
void repeat_passes(CutPlan& plan, const SafetyWishes& wishes);

}  // namespace sim::cut

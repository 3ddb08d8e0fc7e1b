#pragma once

#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// When cuts that follow each other are joined.
struct LinkRules {
  double longest_mm = 10.0;          ///< Longer links are not made, above 0.
  cnc::order::RapidLimits limits{};  ///< The machine's.
};

/// Joins each cut to the next one where that saves time: the beam stays on along a straight link
/// from the end of the one to the start of the other, and the pierce and the rapid fall away. A
/// link is in the waste: half a kerf from all lines that are cut, and a kerf and a half from what
/// tabs hold, so that it crosses neither parts nor what is free. Both cuts are of one layer, beside
/// their lines, and driven as strokes (see Cut::programmed). The order stays as it is. Counts in
/// `safety`.
void link_cuts(CutPlan& plan, const drawing::Drawing& drawn, const LinkRules& rules);

}  // namespace sim::cut

#pragma once

#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Rules for joining consecutive cuts.
struct LinkRules {
  double longest_mm = 10.0;          ///< Greatest length of a link, above 0.
  cnc::order::RapidLimits limits{};  ///< Limits of the machine.
};

/// Joins each cut to the next one where that saves time. The beam stays on along a straight link
/// from the end of one cut to the start of the next, which saves the pierce and the rapid. A link
/// lies in the waste: at least half a kerf from all lines that are cut, and one and a half kerfs
/// from material that tabs hold. So it crosses neither parts nor freed material. Both cuts are of
/// one layer, at an offset from their lines, and driven as strokes (see Cut::programmed). The order
/// does not change. Counts the links in `safety`.
void link_cuts(CutPlan& plan, const drawing::Drawing& drawn, const LinkRules& rules);

}  // namespace sim::cut

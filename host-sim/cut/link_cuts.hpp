#pragma once

#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Rules by which consecutive cuts are joined.
struct LinkRules {
  double longest_mm = 10.0;  ///< Greatest length of a link, above 0.
  /// Limits of the machine, from which the saved time is computed.
  cnc::order::RapidLimits limits{};
};

/// Joins each cut to the next cut where this saves time. The beam stays on along a straight link
/// from the end of one cut to the start of the next cut. This saves the pierce and the rapid. A
/// link is in the waste: at least half a kerf from all lines that are cut, and one and a half kerfs
/// from tabs. So it crosses neither parts nor freed material. Only cuts of one layer are joined, at
/// an offset from their lines, and driven as strokes (see Cut::programmed). The order does not
/// change. Counts the links in `safety`.
void link_cuts(CutPlan& plan, const drawing::Drawing& drawn, const LinkRules& rules);

}  // namespace sim::cut

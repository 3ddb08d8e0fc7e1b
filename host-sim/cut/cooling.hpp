#pragma once

#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// How long a sheet is hot after it was cut, and how far from the cut.
struct CoolingRules {
  double cool_s = 1.0;       ///< After this time heat does not count, above 0.
  double distance_mm = 5.0;  ///< Nor beyond this distance, above 0.
  cnc::order::RapidLimits
      limits{};  ///< The machine's. They bound the time between cuts from below.
};

/// Changes the order where the next pierce would be near to fresh heat and another cut is near at
/// hand that is not: one that is ready (see Cut::after), of the same layer, and for which the
/// machine travels longer by less than the time it would wait. Nothing overtakes a cut of another
/// layer. `after` of all cuts is by the new numbers. Counts in `safety`.
void reorder_for_cooling(CutPlan& plan, const CoolingRules& rules);

/// Sets `wait_s` of each cut so that its pierce comes no sooner than `cool_s` after the beam cut
/// within the distance, by a clock that knows no acceleration and thus is never ahead of the real
/// one. A cut that begins with a link has no pierce, and does not wait.
void wait_for_cooling(CutPlan& plan, const CoolingRules& rules);

}  // namespace sim::cut

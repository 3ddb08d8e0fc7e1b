#pragma once

#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Rules that let the sheet cool between a cut and a pierce near it.
struct CoolingRules {
  double cool_s = 1.0;  ///< Least time between a cut and a later pierce near it, above 0.
  /// Greatest distance between a cut and a pierce that is near it, above 0.
  double distance_mm = 5.0;
  cnc::order::RapidLimits
      limits{};  ///< Limits of the machine, from which the least times of motions are computed.
};

/// Changes the order of cuts so that pierces keep away from fresh heat. If the next cut would have
/// to wait for cooling, another cut that is ready (see Cut::after) may overtake it. The wait of
/// this other cut plus the longer travel must take less time than the wait of the next cut. No cut
/// overtakes a cut of another layer or another turn. Renumbers the cuts, including the numbers in
/// Cut::after. Counts the cuts that moved in `safety`.
void reorder_for_cooling(CutPlan& plan, const CoolingRules& rules);

/// Sets `wait_s` of each cut so that the sheet can cool: the pierce comes at least `cool_s` after
/// the beam last cut within `distance_mm` of the pierce. Times are computed without acceleration,
/// so a wait may be too long, but never too short. A cut that begins with a link has no pierce and
/// does not wait.
void wait_for_cooling(CutPlan& plan, const CoolingRules& rules);

}  // namespace sim::cut

#pragma once

#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// The time and the distance from a cut within which a sheet stays hot.
struct CoolingRules {
  double cool_s = 1.0;       ///< Heat does not count after this time, above 0.
  double distance_mm = 5.0;  ///< Heat does not count beyond this distance, above 0.
  cnc::order::RapidLimits
      limits{};  ///< Limits of the machine. They give a lower bound of the time between cuts.
};

/// Changes the order of cuts so that pierces keep away from fresh heat. If the next cut would have
/// to wait for cooling, another cut may overtake it. This other cut is ready (see Cut::after), and
/// its own wait plus the longer travel take less time than the wait of the next cut. No cut
/// overtakes a cut of another layer or another turn. Afterwards `after` of all cuts has the new
/// numbers. Counts the changes in `safety`.
void reorder_for_cooling(CutPlan& plan, const CoolingRules& rules);

/// Sets `wait_s` of each cut so that its pierce comes at least `cool_s` after the beam cut within
/// `distance_mm`. The clock for this ignores acceleration, so it never runs ahead of the real time.
/// A cut that begins with a link has no pierce and does not wait.
void wait_for_cooling(CutPlan& plan, const CoolingRules& rules);

}  // namespace sim::cut

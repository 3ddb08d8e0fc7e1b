#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Kerfs from a pierce within which heat counts. Neighbours in a nest are one to three kerfs apart,
/// and the edge is discoloured about as far as the kerf is wide: five cover the neighbour's edge
/// and what is hot beyond it. Heavy plate that soaks in heat wants --cool-distance.
inline constexpr double kCoolKerfs = 5.0;

/// What is done so that an order of cuts is safe to run.
struct SafetyWishes {
  bool avoid_freed = false;       ///< Rapids go round what has been cut free.
  double avoid_margin_mm = 0.1;   ///< See AvoidanceRules.
  double lift_mm = 0.0;           ///< Height of Z where there is no way round; 0: none.
  double cool_s = 0.0;            ///< Heat counts for the next pierce so long; 0: it does not.
  double cool_distance_mm = 0.0;  ///< And so near; 0: kCoolKerfs times the widest kerf.
  double chain_mm = 0.0;          ///< Longest link between cuts; 0: none.
  double slice_mm = 0.0;          ///< Size of pieces of the waste; 0: it is not cut up.
  double slice_margin_mm = 5.0;   ///< See SliceRules.
};

/// Does it, and counts it in `safety` of the plan. What cannot be done becomes a fault. Throws
/// std::invalid_argument where the waste of a sheet is to be cut up that stays in one piece.
void make_safe(CutPlan& plan, const drawing::Drawing& drawn, const SafetyWishes& wishes);

/// Returns what was done as lines for people, none where nothing was asked for…
[[nodiscard]] std::vector<std::string> lines_of(const SafetyFigures& figures);

/// …and for programs.
[[nodiscard]] nlohmann::ordered_json json_of(const SafetyFigures& figures);

}  // namespace sim::cut

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Default for the greatest distance between a cut and a pierce that must wait until the cut is
/// cool, in kerfs. Neighbours in a nest are one to three kerfs apart, and an edge is discoloured
/// over about the width of one kerf. Five kerfs cover the neighbour's edge and the hot material
/// beyond it. Heavy plate that stores heat requires a greater --cool-distance.
inline constexpr double kCoolKerfs = 5.0;

/// The measures that the user requires to make an order of cuts safe to run.
struct SafetyWishes {
  bool avoid_freed = false;      ///< Whether rapids go around freed areas.
  double avoid_margin_mm = 0.1;  ///< Margin of AvoidanceRules.
  double lift_mm = 0.0;          ///< Height of Z for rapids without a path; 0: not lifted.
  /// Least time between a cut and a pierce near it; 0: no limit.
  double cool_s = 0.0;
  /// Greatest distance between a cut and a pierce that is near it; 0: kCoolKerfs times the widest
  /// kerf.
  double cool_distance_mm = 0.0;
  double chain_mm = 0.0;         ///< Greatest length of a link between cuts; 0: no links.
  double slice_mm = 0.0;         ///< Greatest size of the pieces of waste; 0: waste is not divided.
  double slice_margin_mm = 5.0;  ///< Margin of the slices, mm; see SliceRules.
};

/// Takes the required measures, and records their effects in `safety` of the plan. A rapid that
/// cannot be made safe becomes a fault. Throws std::invalid_argument if the waste must be divided,
/// although the sheet file requires that it stays in one piece.
void make_safe(CutPlan& plan, const drawing::Drawing& drawn, const SafetyWishes& wishes);

/// Returns the figures as lines of text for the user; none if no measure was required.
[[nodiscard]] std::vector<std::string> lines_of(const SafetyFigures& figures);

/// Returns the figures as JSON for programs.
[[nodiscard]] nlohmann::ordered_json json_of(const SafetyFigures& figures);

}  // namespace sim::cut

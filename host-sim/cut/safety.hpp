#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Distance from a pierce within which heat counts, in kerfs. Neighbours in a nest are one to three
/// kerfs apart, and the edge is discoloured over about one width of the kerf. Five kerfs cover the
/// neighbour's edge and the hot material beyond it. Heavy plate that stores heat needs
/// --cool-distance.
inline constexpr double kCoolKerfs = 5.0;

/// Measures that make an order of cuts safe to run.
struct SafetyWishes {
  bool avoid_freed = false;      ///< Rapids go around freed areas.
  double avoid_margin_mm = 0.1;  ///< Margin, see AvoidanceRules.
  double lift_mm = 0.0;          ///< Height of Z if there is no path around; 0: none.
  /// Time during which heat counts for the next pierce; 0: heat does not count.
  double cool_s = 0.0;
  /// Distance within which heat counts; 0: kCoolKerfs times the widest kerf.
  double cool_distance_mm = 0.0;
  double chain_mm = 0.0;         ///< Greatest length of a link between cuts; 0: no links.
  double slice_mm = 0.0;         ///< Size of the pieces of waste; 0: the waste is not cut up.
  double slice_margin_mm = 5.0;  ///< Margin, see SliceRules.
};

/// Takes the measures, and counts them in `safety` of the plan. What cannot be done becomes a
/// fault. Throws std::invalid_argument if waste is to be cut up of a sheet that stays in one piece.
void make_safe(CutPlan& plan, const drawing::Drawing& drawn, const SafetyWishes& wishes);

/// Returns the figures as lines for people; none if no measure was required.
[[nodiscard]] std::vector<std::string> lines_of(const SafetyFigures& figures);

/// Returns the figures as JSON for programs.
[[nodiscard]] nlohmann::ordered_json json_of(const SafetyFigures& figures);

}  // namespace sim::cut

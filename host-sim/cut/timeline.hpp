#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// The kinds of time in a job.
enum class TimeKind : std::uint8_t {
  kPierce,
  kLead,     ///< Lead-ins, lead-outs and links.
  kContour,  ///< Along edges and drawn lines, overcuts and slices included.
  kTab,      ///< Along edges with the beam off.
  kCornerLoop,
  kCornerDwell,
  kRapid,
  kWait,      ///< At rest with the beam off before a pierce.
  kOverscan,  ///< Between the lines of filled areas, with the beam off.
};
inline constexpr std::size_t kTimeKinds = 9;

/// Return the name of a kind: `pierce`, `lead` … for people, and with underscores for JSON.
[[nodiscard]] std::string_view title_of(TimeKind kind);
[[nodiscard]] std::string_view key_of(TimeKind kind);

/// One motion or rest of a job.
struct TimeStep {
  TimeKind kind = TimeKind::kRapid;
  /// Number of the cut to which the step belongs, as does the rapid before the cut. For the return
  /// to the origin it is the number of cuts.
  std::size_t cut = 0;
  Stroke path{};  ///< Path of the step; both ends are the same for a rest.
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// All steps of a job, one after the other from 0 s on.
struct Timeline {
  std::vector<TimeStep> steps{};

  /// Returns the time of the whole job, s.
  [[nodiscard]] double total_s() const { return steps.empty() ? 0.0 : steps.back().end_s; }
  /// Returns the total time of each kind, s, in the order of TimeKind.
  [[nodiscard]] std::array<double, kTimeKinds> by_kind() const;
};

/// Predicts the timeline of a job on the machine for which its order was chosen, see
/// ControllerClock. The path is always that of the plan, even if the controller computes it itself.
/// Lifts of Z are not counted.
[[nodiscard]] Timeline timeline_of(const CutPlan& plan);

/// Predicts the time of the plan in its present state. Sets `rapids` and `strokes_s` of its order,
/// and returns its timeline. Both add up to the timeline's total. `rapids` are those of
/// rapids_of(), so that they can be compared with the rapids of other orders.
Timeline predict(CutPlan& plan);

/// Returns the timeline with all times scaled in proportion to a new total.
/// @param total_s above 0; a job without time does not change
[[nodiscard]] Timeline scaled_to(Timeline timeline, double total_s);

}  // namespace sim::cut

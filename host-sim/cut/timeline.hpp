#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// What the time of a job is spent on.
enum class TimeKind : std::uint8_t {
  kPierce,
  kLead,     ///< Leads in and out, and links.
  kContour,  ///< Along edges and drawn lines, overcuts and slices included.
  kTab,      ///< Along edges with the beam off.
  kCornerLoop,
  kCornerDwell,
  kRapid,
  kWait,      ///< At rest with the beam off before a pierce.
  kOverscan,  ///< Between the lines of filled areas, with the beam off.
};
inline constexpr std::size_t kTimeKinds = 9;

/// `pierce`, `lead` …, for people; for JSON with underscores.
[[nodiscard]] std::string_view title_of(TimeKind kind);
[[nodiscard]] std::string_view key_of(TimeKind kind);

/// One motion or rest of a job.
struct TimeStep {
  TimeKind kind = TimeKind::kRapid;
  /// Number of the cut that it belongs to, as the rapid before it does; of the return to the
  /// origin the number of cuts.
  std::size_t cut = 0;
  Stroke path{};  ///< Of a rest both ends are the same.
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// Everything that a job does, one after the other from 0 s on.
struct Timeline {
  std::vector<TimeStep> steps{};

  /// Returns the time of the whole job, s.
  [[nodiscard]] double total_s() const { return steps.empty() ? 0.0 : steps.back().end_s; }
  /// Returns the sums by kind, s, in the order of TimeKind.
  [[nodiscard]] std::array<double, kTimeKinds> by_kind() const;
};

/// Predicts when a job does what on the machine for which its order was chosen, see
/// ControllerClock. The path is that of the plan also where the controller finds it by itself;
/// lifts of Z are not counted.
[[nodiscard]] Timeline timeline_of(const CutPlan& plan);

/// Predicts what the plan takes as it is now: sets `rapids` and `strokes_s` of its order, and
/// returns its timeline. Both add up to the timeline's total; rapids are those of rapids_of(), so
/// that they compare with the rapids of other orders.
Timeline predict(CutPlan& plan);

/// Returns the timeline with all times in the same proportion and another total.
/// @param total_s > 0; a job without time stays as it is
[[nodiscard]] Timeline scaled_to(Timeline timeline, double total_s);

}  // namespace sim::cut

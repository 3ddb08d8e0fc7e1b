#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// The kinds of motions and rests among which the time of a job is divided.
enum class TimeKind : std::uint8_t {
  kPierce,
  kLead,     ///< Motions along lead-ins, lead-outs and links.
  kContour,  ///< Motions along edges and drawn lines, including overcuts and slices.
  kTab,      ///< Motions along edges with the beam off.
  kCornerLoop,
  kCornerDwell,
  kRapid,
  kWait,      ///< Rests with the beam off before a pierce, until the sheet is cooler.
  kOverscan,  ///< Motions with the beam off before, between and after the lines of filled areas.
};
inline constexpr std::size_t kTimeKinds = 9;

/// Return the name of a kind for users, such as `corner loops`, and its key in JSON, such as
/// `corner_loop`.
[[nodiscard]] std::string_view title_of(TimeKind kind);
[[nodiscard]] std::string_view key_of(TimeKind kind);

/// One motion or rest of a job.
struct TimeStep {
  TimeKind kind = TimeKind::kRapid;
  /// Number of the cut to which the step belongs. The rapid before a cut belongs to this cut. The
  /// rapid to the end of the job has the number of cuts.
  std::size_t cut = 0;
  Stroke path{};  ///< Path of the step. For a rest, both ends are the same point.
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// All steps of a job, one after the other from 0 s on.
struct Timeline {
  std::vector<TimeStep> steps{};

  /// Returns the total time of the job, s.
  [[nodiscard]] double total_s() const { return steps.empty() ? 0.0 : steps.back().end_s; }
  /// Returns the total time of each kind, s, in the order of TimeKind.
  [[nodiscard]] std::array<double, kTimeKinds> by_kind() const;
};

/// Predicts the timeline of a job on the machine for which its order was chosen; see
/// ControllerClock. The path is that of the plan, even if the controller computes its own
/// compensated path. Lifts of Z are not counted.
[[nodiscard]] Timeline timeline_of(const CutPlan& plan);

/// Predicts the time of the plan as it is now, and returns its timeline. Sets `rapids` and
/// `strokes_s` of `plan.order`; the sum of their times is the total of the timeline. `rapids` is
/// computed by rapids_of(), so that it can be compared with the rapids of other orders.
Timeline predict(CutPlan& plan);

/// Returns the timeline with all times scaled in proportion, so that the total is `total_s`.
/// @param total_s above 0; a timeline whose total is 0 does not change
[[nodiscard]] Timeline scaled_to(Timeline timeline, double total_s);

}  // namespace sim::cut

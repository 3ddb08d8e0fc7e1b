#include <algorithm>

#include "planner/base/units.hpp"
#include "planner/gcode/execution.hpp"
#include "planner/gcode/path_length.hpp"
#include "planner/geometry/spline_length.hpp"

namespace cnc::gcode {
namespace {

/// Longer than any straight motion and any turn of an arc within the range of places. Longer
/// splines, which go from one end of the range to the other several times, are not driven so slowly.
constexpr float kLongestTurnMm = 1.0e7F;

constexpr bool is_arc(MotionMode mode) {
  return mode == MotionMode::kArcClockwise || mode == MotionMode::kArcCounterClockwise;
}

}  // namespace

/// The motion mode acts when its word is in the line, or when there are axis
/// words that no other word of the line claims (Grbl's implicit motion).
Refusal Execution::move() {
  const MotionMode mode = next_.modal.motion;
  const bool straight = mode == MotionMode::kRapid || mode == MotionMode::kLine;
  if (block_.non_modal() == NonModal::kMachineCoordinates && !straight) {
    return block_.blame(FaultDetail::kG53NeedsStraightMotion, ModalGroup::kNonModal);
  }
  if (!moves()) return std::nullopt;
  if (mode == MotionMode::kNone) return block_.blame_first_axis_word(FaultDetail::kAxisWordUnused);
  if (mode == MotionMode::kNurbs) return take_control_point();
  const bool probes = mode >= MotionMode::kProbeContact;
  if (!probes && mode != MotionMode::kNurbsEnd && only_sets_mode()) return std::nullopt;
  if (mode != MotionMode::kRapid) {
    if (const auto fault = check_feed()) return fault;
  }
  if (straight) return move_straight();
  if (probes) return probe();
  return is_arc(mode) ? move_along_arc() : move_along_spline(mode);
}

/// Senders give back the modes that they were told in one line, `G2 … F0` among
/// them: that says which mode, and how fast, and is complete. A lone G1 while no
/// feed is set is refused, as in Grbl.
bool Execution::only_sets_mode() const {
  if (block_.has_axis_word() || block_.has_arc_word()) return false;
  return block_.has('F') || next_.modal.feed > 0.0F ||
         next_.modal.feed_mode == FeedMode::kInverseTime;
}

/// Without a word that claims the axes a centre alone is another whole turn, as in LinuxCNC.
bool Execution::moves() const {
  if (block_.axis_use() != AxisUse::kNone) return block_.axis_use() == AxisUse::kMotion;
  return block_.has_axis_word() || (is_arc(next_.modal.motion) && has_centre_word());
}

/// Rejects a slip that would keep the machine at work for years. What the axes allow counts as
/// well as F; overrides do not.
Refusal Execution::check_durations() {
  Position start = context_.position;
  for (const Action& action : actions_.all()) {
    const bool rapid = action.kind == ActionKind::kRapid;
    const bool arc = action.kind == ActionKind::kArc;
    const bool spline = action.kind == ActionKind::kSpline;
    const bool straight = rapid || action.kind == ActionKind::kLine ||
                          action.kind == ActionKind::kProbe;
    if (!straight && !arc && !spline) continue;
    const float speed = rapid ? options_.slowest_rate_mm_s
                              : std::min(action.feed, options_.slowest_rate_mm_s);
    const float longest = speed * options_.longest_motion_s;
    if (longest < kLongestTurnMm * static_cast<float>(action.turns)) {
      const float length = arc      ? arc_length(start, action)
                           : spline ? length_of(*action.spline)
                                    : straight_length(start, action.end);
      if (length > longest) return too_long(length / speed);
    }
    start = action.end;
  }
  return std::nullopt;
}

Fault Execution::too_long(float seconds) const {
  constexpr float kSecondsPerDay = 86'400.0F;
  constexpr float kMostDays = 1.0e9F;  // As many as the message shows.
  Fault fault{.detail = FaultDetail::kMotionTooLong};
  if (block_.has('F')) {
    fault = block_.blame(fault.detail, 'F');
  } else if (block_.has_axis_word()) {
    fault = block_.blame_first_axis_word(fault.detail);
  }
  fault.value = std::min(seconds / kSecondsPerDay, kMostDays);
  fault.limit = options_.longest_motion_s / kSecondsPerDay;
  return fault;
}

Refusal Execution::check_feed() const {
  const bool inverse_time = next_.modal.feed_mode == FeedMode::kInverseTime;
  const float feed = inverse_time ? inverse_time_ : next_.modal.feed;
  if (feed > 0.0F) return std::nullopt;
  return blame_motion(inverse_time ? FaultDetail::kInverseTimeFeedMissing
                                   : FaultDetail::kFeedMissing);
}

/// Puts the axes that are named where they are to go, in machine coordinates.
/// After G53 the numbers are machine coordinates, in G91 too, as in Grbl.
Refusal Execution::read_target(Position& target) {
  const bool in_machine_coordinates = block_.non_modal() == NonModal::kMachineCoordinates;
  const bool incremental = next_.modal.distance == DistanceMode::kIncremental;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const Decimal* const number = block_.take(kAxisLetters[axis]);
    if (number == nullptr) continue;
    Coordinate place = to_axis_value(axis, *number);
    if (!in_machine_coordinates) {
      place += incremental ? next_.position[axis] : work_offset(next_, places_, axis);
    }
    if (!within_reach(axis, place)) {
      const Fault word = block_.blame(FaultDetail::kTargetOutOfRange, kAxisLetters[axis]);
      return out_of_reach(word, axis, place);
    }
    target[axis] = place;
  }
  return std::nullopt;
}

/// G0 and G1; without axis words they only set the mode.
Refusal Execution::move_straight() {
  if (!block_.has_axis_word()) return std::nullopt;
  Position target = next_.position;
  if (const auto fault = read_target(target)) return fault;
  const bool rapid = next_.modal.motion == MotionMode::kRapid;
  Action& action = actions_.append(rapid ? ActionKind::kRapid : ActionKind::kLine);
  action.end = target;
  if (!rapid) action.feed = straight_speed(target);
  if (!rapid && powers_wait_) {
    action.powers = block_.powers();
    powers_wait_ = false;
  }
  next_.position = target;
  return std::nullopt;
}

/// G38.2…G38.5. The position is the target until set_position() tells where the
/// probe really stopped.
Refusal Execution::probe() {
  if (!block_.has_axis_word()) return blame_motion(FaultDetail::kAxisWordsMissing);
  if (next_.modal.compensation.side != CutterSide::kOn) {
    return blame_motion(FaultDetail::kNotBesideThePath);
  }
  Position target = next_.position;
  if (const auto fault = read_target(target)) return fault;
  if (target == next_.position) return blame_motion(FaultDetail::kProbeGoesNowhere);
  const MotionMode mode = next_.modal.motion;
  Action& action = actions_.append(ActionKind::kProbe);
  action.end = target;
  action.feed = straight_speed(target);
  action.probe.towards_contact =
      mode == MotionMode::kProbeContact || mode == MotionMode::kProbeContactOrNot;
  action.probe.error_if_missed =
      mode == MotionMode::kProbeContact || mode == MotionMode::kProbeRelease;
  next_.position = target;
  return std::nullopt;
}

float Execution::straight_speed(const Position& target) const {
  const ModalState& modal = next_.modal;
  if (modal.feed_mode == FeedMode::kInverseTime) {
    return straight_length(next_.position, target) * inverse_time_ / kSecondsPerMinute;
  }
  return only_rotary_axes_move(next_.position, target) ? modal.rotary_feed : modal.feed;
}

/// The word of the motion, or what stands for it.
Fault Execution::blame_motion(FaultDetail detail) const {
  if (block_.has(ModalGroup::kMotion)) return block_.blame(detail, ModalGroup::kMotion);
  return block_.blame_first_axis_word(detail);
}

}  // namespace cnc::gcode

#include "planner/base/units.hpp"
#include "planner/gcode/execution.hpp"
#include "planner/gcode/path_length.hpp"

namespace cnc::gcode {
namespace {

/// Speed, in mm/s, above which no motion is checked for its duration: even a motion through the
/// complete range of positions takes less than a month.
constexpr float kSlowMmPerS = 4.0F;

constexpr bool is_arc(MotionMode mode) {
  return mode == MotionMode::kArcClockwise || mode == MotionMode::kArcCounterClockwise;
}

}  // namespace

/// Handles the motion of the line. The motion mode is applied if the line has its word, or if the
/// line has axis words that no other word of the line uses (Grbl's implicit motion).
Refusal Execution::move() {
  const MotionMode mode = next_.modal.motion;
  const bool straight = mode == MotionMode::kRapid || mode == MotionMode::kLine;
  if (block_.non_modal() == NonModal::kMachineCoordinates && !straight) {
    return block_.blame(FaultDetail::kG53NeedsStraightMotion, ModalGroup::kNonModal);
  }
  if (!moves()) return std::nullopt;
  if (mode == MotionMode::kNone) return block_.blame_first_axis_word(FaultDetail::kAxisWordUnused);
  if (next_.modal.tool_centre && !straight && !is_arc(mode)) {
    return blame_motion(FaultDetail::kNotAtToolCentre);
  }
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

/// Returns whether the motion word only sets the mode. Senders restore the reported modes in one
/// line that contains `G2 … F0`. Such a line gives mode and feed, and is accepted without axis
/// words. A line with only G1 is refused while no feed is set, as in Grbl.
bool Execution::only_sets_mode() const {
  if (block_.has_axis_word() || block_.has_arc_word()) return false;
  return block_.has('F') || next_.modal.feed > 0.0F ||
         next_.modal.feed_mode == FeedMode::kInverseTime;
}

/// Returns whether the line moves the machine. In an arc mode, a line with only a centre is another
/// full turn, as in LinuxCNC, unless a word of the line uses the axis words.
bool Execution::moves() const {
  if (block_.axis_use() != AxisUse::kNone) return block_.axis_use() == AxisUse::kMotion;
  return block_.has_axis_word() || (is_arc(next_.modal.motion) && has_centre_word());
}

/// Refuses a motion that would take longer than the options permit, because it is a mistake.
/// Overrides and slower axes are not considered.
Refusal Execution::check_duration(float length_mm, float speed_mm_s) const {
  if (length_mm <= speed_mm_s * options_.longest_motion_s) return std::nullopt;
  Fault fault{.detail = FaultDetail::kMotionTooLong};
  if (block_.has('F')) fault = block_.blame(fault.detail, 'F');
  constexpr float kDaysPerSecond = 1.0F / 86'400.0F;
  fault.limit = options_.longest_motion_s * kDaysPerSecond;
  return fault;
}

/// Completes an action that goes to the target of the line at the present feed, and checks its
/// duration. Most motions are so fast that the check does not require their length.
Refusal Execution::go_straight(Action& action, const Position& target) {
  const Position start = next_.position;
  action.end = target;
  action.feed = straight_speed(target);
  next_.position = target;
  if (action.feed > kSlowMmPerS) return std::nullopt;
  return check_duration(straight_length(start, target), action.feed);
}

Refusal Execution::check_feed() const {
  const bool inverse_time = next_.modal.feed_mode == FeedMode::kInverseTime;
  const float feed = inverse_time ? inverse_time_ : next_.modal.feed;
  if (feed > 0.0F) return std::nullopt;
  return blame_motion(inverse_time ? FaultDetail::kInverseTimeFeedMissing
                                   : FaultDetail::kFeedMissing);
}

/// Sets the axes of `target` that the line names, in machine coordinates. After G53 the numbers are
/// machine coordinates even in G91, as in Grbl.
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

/// Handles G0 and G1. Without axis words, they only set the mode.
Refusal Execution::move_straight() {
  if (!block_.has_axis_word()) return std::nullopt;
  Position target = next_.position;
  if (const auto fault = read_target(target)) return fault;
  const bool rapid = next_.modal.motion == MotionMode::kRapid;
  Action& action = actions_.append(rapid ? ActionKind::kRapid : ActionKind::kLine);
  action.end = target;
  if (!rapid && powers_wait_) {
    action.powers = block_.powers();
    powers_wait_ = false;
  }
  if (!rapid) return go_straight(action, target);
  next_.position = target;
  return std::nullopt;
}

/// Handles G38.2…G38.5. The position is assumed to be the target until set_position() reports the
/// position where the probe has stopped.
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
  action.probe.towards_contact =
      mode == MotionMode::kProbeContact || mode == MotionMode::kProbeContactOrNot;
  action.probe.error_if_missed =
      mode == MotionMode::kProbeContact || mode == MotionMode::kProbeRelease;
  return go_straight(action, target);
}

float Execution::straight_speed(const Position& target) const {
  const ModalState& modal = next_.modal;
  if (modal.feed_mode == FeedMode::kInverseTime) {
    return straight_length(next_.position, target) * inverse_time_ / kSecondsPerMinute;
  }
  return only_rotary_axes_move(next_.position, target) ? modal.rotary_feed : modal.feed;
}

/// Returns a fault at the motion word or, if there is none, at the first axis word.
Fault Execution::blame_motion(FaultDetail detail) const {
  if (block_.has(ModalGroup::kMotion)) return block_.blame(detail, ModalGroup::kMotion);
  return block_.blame_first_axis_word(detail);
}

}  // namespace cnc::gcode

#include "firmware/machine/machine.hpp"
#include "planner/base/truncate.hpp"

namespace cnc {

using gcode::Action;
using gcode::ActionKind;

namespace {

constexpr float kMicrosecondsPerSecond = 1.0e6F;
constexpr float kFullScale = 65535.0F;

std::uint16_t to_full_scale(float share) {
  const float legal = share < 0.0F ? 0.0F : (share > 1.0F ? 1.0F : share);
  return static_cast<std::uint16_t>(legal * kFullScale + 0.5F);
}

}  // namespace

/// True when the action is done; false to be asked again at the next poll.
bool Machine::run(const Action& action) {
  switch (action.kind) {
    case ActionKind::kRapid:
      return move_straight(action, 0.0F);
    case ActionKind::kLine:
      return move_straight(action, action.feed);
    case ActionKind::kArc:
      return move_arc(action);
    case ActionKind::kProbe:
      return probe(action);
    case ActionKind::kDwell:
      return dwell(action);
    case ActionKind::kSpindleSpeed:
      if (tool_.speed_waits_for_standstill() && !motion_.drained()) return false;
      tool_.set_speed(action.value);
      return true;
    case ActionKind::kSpindle:
      if (!motion_.drained()) return false;
      tool_.set_mode(action.spindle);
      return true;
    case ActionKind::kCoolant:
      if (!motion_.drained()) return false;
      outputs_.set_coolant(action.coolant.mist, action.coolant.flood);
      return true;
    case ActionKind::kOutput:
      return switch_output(action.output);
    case ActionKind::kPause:
      return pause(action);
    case ActionKind::kEnd:
      return end_program();
    case ActionKind::kTool:
    case ActionKind::kOffsets:
      return true;
  }
  return true;
}

void Machine::append(const PathElement& element, float feed) {
  const auto appended = motion_.append({.element = element,
                                        .feed_mm_s = feed,
                                        .beam = tool_.command_for(feed <= 0.0F),
                                        .outputs = with_next_motion_,
                                        .line = lines_accepted_});
  // The interpreter keeps targets inside the motors' range, and arcs are divided.
  CNC_ASSERT(appended.ok());
  if (appended.value()) with_next_motion_ = {};
}

bool Machine::move_straight(const Action& action, float feed) {
  if (!motion_.has_room()) return false;
  append({.start = motion_.target(), .end = action.end}, feed);
  return true;
}

/// Element by element, as the planner has room.
bool Machine::move_arc(const Action& action) {
  if (!arc_) {
    arc_.emplace(CentreArc{.start = motion_.target(),
                           .end = action.end,
                           .plane = action.plane,
                           .centre = action.centre,
                           .clockwise = action.clockwise,
                           .turns = action.turns});
    arc_index_ = 0;
  }
  while (arc_index_ < arc_->count()) {
    if (!motion_.has_room()) return false;
    append(arc_->element(arc_index_++), action.feed);
  }
  arc_.reset();
  return true;
}

bool Machine::dwell(const Action& action) {
  if (!motion_.drained()) return false;
  if (!dwelling_) {
    dwelling_ = true;
    dwell_begins_ = true;
    dwell_left_us_ = truncated(action.seconds * kMicrosecondsPerSecond);
  }
  if (dwell_left_us_ > 0) return false;
  dwelling_ = false;
  return true;
}

bool Machine::switch_output(const gcode::OutputChange& change) {
  const std::uint16_t level = to_full_scale(change.value);
  const auto bit = static_cast<std::uint8_t>(1U << change.number);
  if (!change.with_motion) {
    if (change.analog) {
      outputs_.set_analog_output(change.number, level);
    } else {
      outputs_.set_digital(change.number, level != 0);
    }
    return true;
  }
  motion::OutputChanges& next = with_next_motion_;
  if (!change.analog) {
    next.raise = static_cast<std::uint8_t>(level != 0 ? next.raise | bit : next.raise & ~bit);
    next.lower = static_cast<std::uint8_t>(level != 0 ? next.lower & ~bit : next.lower | bit);
    return true;
  }
  // One analog change fits into a block; a second channel waits for standstill.
  const bool taken = next.analog_channel != motion::OutputChanges::kNoAnalog &&
                     next.analog_channel != change.number;
  if (taken && !motion_.drained()) return false;
  if (taken) outputs_.set_analog_output(next.analog_channel, next.analog_value);
  next.analog_channel = change.number;
  next.analog_value = level;
  return true;
}

bool Machine::pause(const Action& action) {
  if (action.number == 1) return true;  // M1: there is no optional-stop switch yet.
  if (!motion_.drained()) return false;
  if (!pause_seen_) {
    pause_seen_ = true;
    paused_ = true;
  }
  if (paused_) return false;
  pause_seen_ = false;
  return true;
}

bool Machine::end_program() {
  if (!motion_.drained()) return false;
  set_overrides({});
  tool_.off();
  outputs_.set_coolant(false, false);
  program_ended_ = true;
  return true;
}

/// Straight towards the target until the probe input changes, then as short a
/// way further as the limits allow; what is left of the way is dropped.
bool Machine::probe(const Action& action) {
  switch (probing_) {
    case Probing::kNo:
      if (!motion_.drained()) return false;
      probed_.reset();
      if (drive_.probe_contact() == action.probe.towards_contact) {
        raise_alarm(Alarm::kProbeAtTarget);
        return false;
      }
      drive_.arm_probe(action.probe.towards_contact);
      append({.start = motion_.target(), .end = action.end}, action.feed);
      probing_ = Probing::kMoving;
      return false;
    case Probing::kMoving:
      if (drive_.probe_hit()) {
        motion_.halt();
        probing_ = Probing::kStopping;
        return false;
      }
      return motion_.drained() && finish_probe(action);
    case Probing::kStopping:
      return (motion_.halted() || motion_.drained()) && finish_probe(action);
  }
  return true;
}

bool Machine::finish_probe(const Action& action) {
  probing_ = Probing::kNo;
  drive_.disarm_probe();
  if (!drive_.probe_hit()) {
    if (!action.probe.error_if_missed) return true;
    raise_alarm(Alarm::kProbeMissed);
    return false;
  }
  probed_ = motion_.place_of(drive_.probe_position());
  motion_.drop_rest();
  if (!held_) motion_.go_on();
  interpreter_.set_position(motion_.target());
  return true;
}

}  // namespace cnc

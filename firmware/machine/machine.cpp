#include "firmware/machine/machine.hpp"

#include <algorithm>

namespace cnc {

using gcode::Action;
using gcode::ActionKind;

Machine::Machine(StepDrive& drive, hal::AuxiliaryOutputs& outputs)
    : drive_{drive}, outputs_{outputs}, motion_{drive, limits_}, tool_{drive, outputs} {
  apply_settings();
}

gcode::Refusal Machine::accept(std::string_view line) {
  CNC_ASSERT(!busy() && alarm_ == Alarm::kNone);
  const auto actions = interpreter_.interpret(line);
  if (!actions.ok()) return actions.error();
  if (!actions.value().empty()) program_ended_ = false;
  ++lines_accepted_;
  waiting_ = actions.value();
  run_actions();
  return {};
}

void Machine::poll(hal::TickCount now) {
  const std::int32_t elapsed_us = polled_ ? now.since(last_poll_) : 0;
  last_poll_ = now;
  polled_ = true;
  if (aborting_) {
    if (drive_.running()) return;
    drop_everything();
  }
  if (drive_.take_starved()) raise_alarm(Alarm::kStarved);
  // The time since the last poll began before the dwell did.
  if (dwelling_ && !held_ && !dwell_begins_) dwell_left_us_ -= elapsed_us;
  dwell_begins_ = false;
  run_actions();
  motion_.feed_drive();
}

void Machine::run_actions() {
  while (!waiting_.empty() && run(waiting_.front())) waiting_ = waiting_.subspan(1);
}

MachineState Machine::state() const {
  if (alarm_ != Alarm::kNone) return MachineState::kAlarm;
  if (held_ || paused_) return MachineState::kHold;
  return idle() ? MachineState::kIdle : MachineState::kRun;
}

void Machine::feed_hold() {
  if (alarm_ != Alarm::kNone) return;
  held_ = true;
  motion_.halt();
}

void Machine::resume() {
  held_ = false;
  paused_ = false;
  if (probing_ != Probing::kStopping) motion_.go_on();
}

void Machine::set_overrides(const OverridePercent& percent) {
  percent_ = {.feed = std::clamp(percent.feed, 10, 200),
              .rapid = std::clamp(percent.rapid, 5, 100),
              .power = std::clamp(percent.power, 10, 200)};
  motion_.set_overrides({.feed = 0.01F * static_cast<float>(percent_.feed),
                         .rapid = 0.01F * static_cast<float>(percent_.rapid),
                         .power = 0.01F * static_cast<float>(percent_.power)});
  tool_.set_override(0.01F * static_cast<float>(percent_.power));
}

void Machine::abort() {
  abort_in_motion_ = drive_.running() && !motion_.halted();
  aborting_ = true;
  tool_.off();
  drive_.abort();
}

void Machine::drop_everything() {
  aborting_ = false;
  waiting_ = {};
  arc_.reset();
  with_next_motion_ = {};
  dwelling_ = false;
  held_ = false;
  paused_ = false;
  pause_seen_ = false;
  probing_ = Probing::kNo;
  drive_.disarm_probe();
  tool_.reset();
  outputs_.set_coolant(false, false);
  motion_.drop_rest();
  motion_.go_on();
  interpreter_.reset();
  interpreter_.set_position(motion_.target());
  if (abort_in_motion_) raise_alarm(Alarm::kAbortInMotion);
  abort_in_motion_ = false;
}

void Machine::raise_alarm(Alarm alarm) {
  tool_.off();
  alarm_ = alarm;
  if (!aborting_) {
    aborting_ = true;
    drive_.abort();
  }
}

Result<float, SettingError> Machine::change_setting(std::uint16_t number, float value) {
  CNC_ASSERT(idle());
  const bool other_scale =
      number >= setting::kStepsPerMm && number < setting::kStepsPerMm + kAxisCount;
  const float before = other_scale ? settings_.get(number) : 0.0F;
  const auto stored = settings_.set(number, value);
  if (!stored.ok()) return stored;
  if (other_scale && !place_fits(number - setting::kStepsPerMm)) {
    static_cast<void>(settings_.set(number, before));
    return SettingError::kPlaceLost;
  }
  apply_settings();
  if (other_scale) {
    // The motors stand where they are; that is another place now.
    motion_.drop_rest();
    interpreter_.set_position(motion_.target());
  }
  return stored;
}

/// Whether the motor's present step is within reach at the resolution stored.
bool Machine::place_fits(std::size_t axis) const {
  const AxisScale scale{settings_.get(setting::kStepsPerMm, axis)};
  const Coordinate place = scale.place_of(drive_.position()[axis]);
  const Coordinate reach = gcode_options_from(settings_).reach[axis];
  return place >= -reach && place <= reach;
}

void Machine::apply_settings() {
  limits_ = limits_from(settings_);
  drive_.set_timing(step_timing_from(settings_));
  interpreter_.set_options(gcode_options_from(settings_));
  tool_.configure({.most_speed = settings_.get(setting::kMostSpindleSpeed),
                   .least_speed = settings_.get(setting::kLeastSpindleSpeed),
                   .laser = settings_.get(setting::kLaserMode) != 0.0F});
}

}  // namespace cnc

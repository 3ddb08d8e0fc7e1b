#include "firmware/machine/machine.hpp"

namespace cnc {

void Machine::feed_hold() {
  if (tool_change_.open()) return stop_in_tool_change();
  if (resumption_.pending()) cancel_restart();
  if (state_.take(Event::kHold)) motion_.halt();
}

void Machine::lose_link() {
  stop_for(Alarm::kLinkSilent);
  tool_.suspend(true);
  gap_.begin();
}

void Machine::jog_cancel() {
  if (tool_change_.open()) return stop_in_tool_change();
  if (state_.take(Event::kJogCancel)) motion_.halt();
}

/// Resumes the motion immediately, or after a suspended spindle has come up to speed.
void Machine::resume() {
  if (state_.in(Mode::kDoor)) return resume_from_door();
  if (!state_.in(Mode::kHold) && !state_.in(Mode::kTool)) return;
  if (alarm_.stops() || inputs().door || resumption_.pending()) return;
  if (tool_change_.open()) return tool_change_.end();
  resumption_.begin();
  if (tool_.suspended()) {
    tool_.suspend(false);
    if (tool_turns()) resumption_.wait(settings().get(setting::kSpindleRestoreDelay));
  }
  if (resumption_.over()) restart();
}

void Machine::restart() {
  resumption_.end();
  tool_change_.forget_wanted();
  static_cast<void>(state_.take(Event::kResume));
  if (probing_.phase() != ProbeCycle::Phase::kStopping) motion_.go_on();
}

/// Cancels a resumption, because a hold was requested before the spindle was up to speed.
void Machine::cancel_restart() {
  resumption_.cancel();
  tool_.suspend(true);
}

/// Returns whether the tool is a spindle that is on. Such a tool takes time to come up to speed.
bool Machine::tool_turns() const {
  return tool_.mode() != gcode::SpindleMode::kOff && !tool_.is_laser();
}

void Machine::toggle_spindle_stop() {
  if (!state_.in(Mode::kHold) || resumption_.pending() || !motion_.at_rest()) return;
  tool_.suspend(!tool_.suspended());
}

void Machine::toggle_coolant(gcode::Coolant which) {
  if (!state_.in(Mode::kFree) && !state_.in(Mode::kHold)) return;
  gcode::Coolant wanted = coolant_.wanted();
  wanted.mist = wanted.mist != which.mist;
  wanted.flood = wanted.flood != which.flood;
  coolant_.set(wanted);
  interpreter_.set_coolant(wanted);
}

bool Machine::toggle_block_delete() {
  memory_.check_settings();
  switches_.block_delete_turned = !switches_.block_delete_turned;
  apply_settings();
  return interpreter_.options().block_delete;
}

void Machine::set_overrides(const OverridePercent& percent) {
  switches_.set_overrides(percent);
  const OverridePercent& set = switches_.overrides;
  motion_.set_overrides({.feed = 0.01F * static_cast<float>(set.feed),
                         .rapid = 0.01F * static_cast<float>(set.rapid),
                         .power = 0.01F * static_cast<float>(set.power)});
  tool_.set_override(0.01F * static_cast<float>(set.power));
}

bool Machine::sleep() {
  if (!idle() || alarm_.cuts_off() || !state_.take(Event::kSleep)) return false;
  tool_.off();
  coolant_.reset();
  return true;
}

bool Machine::toggle_check_mode() {
  if (state_.in(Mode::kCheck)) {
    reset();
    return true;
  }
  return idle() && !alarm_.cuts_off() && state_.take(Event::kCheck);
}

bool Machine::unlock() {
  if (alarm_.needs_reset() || inputs().door || inputs().emergency_stop) return false;
  if (!state_.take(Event::kUnlock)) return false;
  alarm_.end();
  return true;
}

}  // namespace cnc

#include "firmware/machine/machine.hpp"

namespace cnc {

/// Resets the machine. If this cuts motion off, motors may lose steps, so the position becomes
/// unknown.
void Machine::reset() {
  const bool homing = state_.in(Mode::kHome);
  const bool slept = state_.in(Mode::kSleep);
  if (homing) {
    raise_alarm(Alarm::kHomingReset);
  } else if (drive_.running() && !alarm_.cuts_off()) {
    raise_alarm(Alarm::kAbortInMotion);
  }
  alarm_.set_needs_reset(inputs().emergency_stop);
  // In sleep the motors had no current, so they may have been turned by hand.
  if (slept) set_homed(0);
  set_overrides({});
  cut_off();
}

void Machine::emergency_stop() {
  raise_alarm(Alarm::kEmergencyStop);
  alarm_.set_needs_reset(true);
}

void Machine::raise_alarm(Alarm alarm) {
  if (drive_.running() || alarm == Alarm::kStarved) set_homed(0);
  if (!state_.take(Event::kAlarm)) return;
  if (state_.in(Mode::kAlarm)) alarm_.set(alarm);
  alarm_.require_reset_for(alarm);
  cut_off();
}

/// Switches the beam or spindle off immediately. The motors stop within one interrupt. Remaining
/// actions and motion are dropped in a later cycle, when the motors have stopped.
void Machine::cut_off() {
  alarm_.cut_off();
  tool_.off();
  drive_.abort();
}

void Machine::drop_everything() {
  alarm_.drop();
  if (tool_change_.open()) close_tool_change();
  news_.line_failed.drop();
  actions_.clear();
  jog_.reset();
  resumption_.cancel();
  tool_change_.forget_wanted();
  probing_.cancel();
  progress_.reentry().cancel();
  gap_.leave();
  drive_.disarm_probe();
  homing_.cancel();
  tool_.reset();
  rest_light_.renew();
  rest_light_.forget_program();
  coolant_.reset();
  tool_centre_ = {};
  motion_.set_tool_centre(tool_centre_);
  motion_.go_on();
  side_.begin(motion_.motor_place());
  compensated_.reset();
  interpreter_.reset();
  interpreter_.set_position(motion_.target());
  static_cast<void>(state_.take(Event::kReset));
  lock_until_homed();
}

/// Raises the alarm kHomingRequired if $22 requires a homing cycle before any other motion.
void Machine::lock_until_homed() {
  const bool required = has_homing_option(settings(), homing_option::kEnabled) &&
                        has_homing_option(settings(), homing_option::kRequired);
  if (!required || homed() != 0 || !state_.in(Mode::kFree)) return;
  static_cast<void>(state_.take(Event::kAlarm));
  alarm_.set(Alarm::kHomingRequired);
}

}  // namespace cnc

#include "firmware/machine/machine.hpp"

namespace cnc {

HomingRefusal Machine::why_not_home(std::uint8_t axes) const {
  using enum HomingRefusal;
  if (!has_homing_option(settings(), homing_option::kEnabled)) return kSwitchedOff;
  if (axes != 0 && !has_homing_option(settings(), homing_option::kSingleAxis)) return kAllAxesOnly;
  if (inputs().door) return kDoorOpen;
  if (inputs().emergency_stop) return kEmergencyStop;
  const bool fit = state_.allows(Event::kHome) && idle() && !busy() && !alarm_.needs_reset();
  return fit ? kNone : kNotNow;
}

void Machine::home(std::uint8_t axes) {
  CNC_ASSERT(why_not_home(axes) == HomingRefusal::kNone);
  static_cast<void>(state_.take(Event::kHome));
  alarm_.end();
  forget_exit();
  end_tool_centre();
  set_homed(axes == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(homed() & ~axes));
  homing_.start(axes, tool_.command_for(true));
}

void Machine::attend_homing(std::int32_t elapsed_us) {
  using enum Homing::Outcome;
  switch (homing_.poll(inputs_.raw(), elapsed_us)) {
    case kGoingOn:
      return;
    case kNoSwitch:
      return raise_alarm(Alarm::kHomingNoSwitch);
    case kStillClosed:
      return raise_alarm(Alarm::kHomingPullOff);
    case kSecondSwitch:
      return raise_alarm(Alarm::kHomingSecondSwitch);
    case kDone:
      break;
  }
  set_homed(static_cast<std::uint8_t>(homed() | homing_.found()));
  interpreter_.set_position(motion_.target());
  static_cast<void>(state_.take(Event::kOver));
}

}  // namespace cnc

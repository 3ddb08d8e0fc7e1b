#include "firmware/machine/machine.hpp"

namespace cnc {

/// Stops because the present line must not be driven, for example because it would leave the
/// travel. The line moves nothing. Earlier motion slows down to rest, and then `alarm` is raised.
/// The position stays known.
void Machine::stop_for(Alarm alarm) {
  alarm_.stop_for(alarm);
  static_cast<void>(state_.take(Event::kHold));
  motion_.halt();
}

/// Checks a line in check mode, including its compensated path. The line has no other effect.
void Machine::judge(gcode::Actions actions, const Position& from) {
  if (leaves_travel(actions, from)) return raise_alarm(Alarm::kSoftLimit);
  for (const gcode::Action& action : actions) {
    if (action.kind == gcode::ActionKind::kToolCentre) judge_tool_centre();
    if (action.kind != gcode::ActionKind::kEnd) continue;
    if (tool_centre_.active()) judge_tool_centre();
    news_.program_ended.raise();
  }
  const bool beside = compensated_.compensates() || compensated_.beside();
  if (!beside && interpreter_.state().compensation.side == gcode::CutterSide::kOn) return;
  if (!beside) compensated_.stand_at(from);
  actions_.begin(actions, false);
}

/// Raises the alarm of a limit switch. Does nothing during homing, which seeks the switches, and in
/// an alarm or asleep, where nothing moves.
void Machine::hit_limit() {
  if (state_.in(Mode::kHome) || state_.in(Mode::kAlarm) || state_.in(Mode::kSleep)) return;
  raise_alarm(Alarm::kHardLimit);
}

/// Sets the axes whose position is known, bit i for axis i. If there is none, the noted progress
/// can be re-entered only after homing.
void Machine::set_homed(std::uint8_t axes) {
  if (axes == 0) progress_.lose_place();
  travel_.set_homed(axes, settings());
}

}  // namespace cnc

#include "firmware/machine/machine.hpp"

namespace cnc {

MachineStatus Machine::status() const {
  switch (state_.mode()) {
    case Mode::kFree:
      return {.state =
                  idle() && !actions_.pauses_after() ? MachineState::kIdle : MachineState::kRun};
    case Mode::kJog:
    case Mode::kJogEnding:
      return {.state = MachineState::kJog};
    case Mode::kHome:
      return {.state = MachineState::kHome};
    case Mode::kCheck:
      return {.state = MachineState::kCheck};
    case Mode::kHold:
      return {.state = MachineState::kHold,
              .substate = motion_.at_rest() ? std::uint8_t{0} : std::uint8_t{1}};
    case Mode::kDoor:
      return {.state = MachineState::kDoor, .substate = door_.substate(inputs().door)};
    case Mode::kTool:
      return {.state = MachineState::kTool};
    case Mode::kSleep:
      return {.state = MachineState::kSleep};
    case Mode::kAlarm:
      return {.state = MachineState::kAlarm};
  }
  return {};
}

bool Machine::tool_runs() const {
  return tool_.mode_now() != gcode::SpindleMode::kOff && (!tool_.is_laser() || rest_light_.lit());
}

float Machine::spindle_now() const {
  const float duty = static_cast<float>(drive_.power()) / motion::kFullOutput;
  return set_up_.limits().beam.table.share_of(duty) * tool_.max_speed();
}

}  // namespace cnc

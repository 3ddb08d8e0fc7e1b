#include "firmware/machine/machine.hpp"

namespace cnc {
namespace {

/// Returns whether the mode is G1, G2 or G3: only in these modes may M3 switch the beam on for a
/// dot at rest.
bool cuts_by_mode(gcode::MotionMode mode) {
  return mode >= gcode::MotionMode::kLine && mode <= gcode::MotionMode::kArcCounterClockwise;
}

}  // namespace

Machine::Machine(StepDrive& drive,
                 motion::Pixels& pixels,
                 hal::AuxiliaryOutputs& outputs,
                 hal::MachineInputs& inputs,
                 KeptProgress* kept)
    : drive_{drive},
      outputs_{outputs},
      input_port_{inputs},
      tool_{drive, outputs},
      coolant_{outputs},
      gap_{drive, motion_},
      progress_{kept},
      motor_enable_{outputs, settings()},
      homing_{drive, motion_, settings()},
      motion_{drive, set_up_.limits(), pixels},
      side_{drive, motion_, set_up_.limits()} {
  watch_memory();
  apply_settings();
}

bool Machine::locked() const {
  switch (state_.mode()) {
    case Mode::kAlarm:
    case Mode::kSleep:
    case Mode::kJog:
    case Mode::kJogEnding:
    case Mode::kHome:
      return true;
    default:
      return false;
  }
}

bool Machine::busy() const {
  return !actions_.empty() || progress_.reentry().has_rest() || jog_ || actions_.pauses_after() ||
         alarm_.stops() || alarm_.cuts_off() || door_stops_jog() || tool_change_.busy() ||
         state_.in(Mode::kHome);
}

bool Machine::beam_works() const {
  const bool on = tool_.is_laser() && tool_.mode_now() != gcode::SpindleMode::kOff;
  return on && state_.in(Mode::kFree) && (!motion_.drained() || rest_light_.lit());
}

bool Machine::idle() const {
  return actions_.empty() && !progress_.reentry().has_rest() && !jog_ && !state_.in(Mode::kHome) &&
         !compensated_.active() && !tool_change_.open() && motion_.drained();
}

gcode::Refusal Machine::accept(std::string_view line) {
  const gcode::Refusal refusal = take_line(line);
  if (!actions_.empty()) run_actions();
  return refusal;
}

/// Interprets a line. The actions of the line are run later, by run_actions().
gcode::Refusal Machine::take_line(std::string_view line) {
  CNC_ASSERT(!busy() && !locked());
  const Position from = interpreter_.position();
  // The interpreter and the machine follow the same lines, so their positions differ only if memory
  // was corrupted.
  CNC_ASSERT(state_.in(Mode::kCheck) || from == target());
  news_.path_fault.reset();
  const auto actions = interpreter_.interpret(line);
  if (!actions.ok()) return actions.error();
  if (interpreter_.places_revision() != memory_.trusted_places()) trust_places();
  if (actions.value().empty()) return {};
  if (state_.in(Mode::kCheck)) {
    judge(actions.value(), from);
    return {};
  }
  if (leaves_travel(actions.value(), from)) return leave_travel(from);
  actions_.begin(actions.value(), switches_.single_block && !tool_change_.open());
  return {};
}

/// Handles a line that would leave the travel. Stops a program with an alarm. In a tool change,
/// refuses only the line, and the program continues to wait.
gcode::Refusal Machine::leave_travel(const Position& from) {
  if (!tool_change_.open()) {
    stop_for(Alarm::kSoftLimit);
    return {};
  }
  interpreter_.set_position(from);
  return gcode::Fault{.detail = gcode::FaultDetail::kBeyondTravel};
}

void Machine::poll(hal::TickCount now) {
  if (clock_.is_new()) lock_until_homed();
  const std::int32_t elapsed_us = clock_.begin(now);
  if (inputs_.poll(input_port_.read_inputs(), elapsed_us)) attend_inputs();
  if (alarm_.cuts_off()) {
    if (drive_.running()) return;
    drop_everything();
  }
  if (drive_.take_starved()) raise_alarm(Alarm::kStarved);
  if (state_.in(Mode::kFree) || tool_change_.open()) actions_.pass(elapsed_us);
  resumption_.pass(elapsed_us);
  note_progress();
  gap_.follow();
  attend_mode(elapsed_us);
  actions_.begin_cycle();
  run_actions();
  attend_rest_light(elapsed_us);
  if (!compensated_.compensates()) motion_.stay_on_path();
  motion_.attend(elapsed_us);
  motor_enable_.attend(motor_need(), elapsed_us);
  const bool rested = !drive_.running();
  if (motor_enable_.ready()) {
    side_.feed_drive();
    motion_.feed_drive();
  }
  drive_.settle();
  if (rested && drive_.running()) memory_.check_settings();
}

/// Advances the task of the present mode. If a stop for an alarm is complete, raises the alarm
/// instead.
void Machine::attend_mode(std::int32_t elapsed_us) {
  if (alarm_.stops() && motion_.at_rest()) {
    find_gap();
    return raise_alarm(alarm_.stopping_for());
  }
  switch (state_.mode()) {
    case Mode::kJog:
    case Mode::kJogEnding:
      return attend_jog();
    case Mode::kHome:
      return attend_homing(elapsed_us);
    case Mode::kDoor:
      return attend_door();
    case Mode::kFree:
      // An input that is still active after a reset causes no new event, so the states of both
      // inputs are checked here.
      if (inputs().emergency_stop) return emergency_stop();
      if (inputs().door) safety_door();
      return;
    case Mode::kHold:
    case Mode::kTool:
      if (tool_change_.open()) attend_tool_change();
      if (resumption_.pending() && resumption_.over()) restart();
      return;
    default:
      return;
  }
}

/// Runs the waiting actions. In a hold, lines are still planned. In the door stages, no action
/// runs, so that no action switches an output.
void Machine::run_actions() {
  if (alarm_.cuts_off() || state_.in(Mode::kDoor)) return;
  if (alarm_.stops() || tool_change_.stage() == ToolChange::Stage::kStopping) return;
  if (compensated_.active()) give_out();
  while (drive_rest() && !actions_.empty() && run(actions_.front())) {
    actions_.drop_front();
  }
  const bool is_done = actions_.empty() && !progress_.reentry().has_rest();
  if (is_done && actions_.pauses_after() && pause()) actions_.end_pause_after();
}

bool Machine::may_light_at_rest() const {
  const bool dot = rest_light_.wish() == RestLight::Wish::kDot;
  return rest_light_.wish() != RestLight::Wish::kNone && tool_.is_laser() &&
         tool_.mode_now() == gcode::SpindleMode::kConstant && state_.in(Mode::kFree) &&
         !alarm_.stops() && !progress_.reentry().active() &&
         (!dot || cuts_by_mode(interpreter_.state().motion));
}

/// Returns the duty that the power table gives for S and the override; 65535 is full.
std::uint16_t Machine::duty_at_rest() const {
  const float share = tool_.share_now();
  return share > 0.0F ? to_full_scale(set_up_.limits().beam.table.duty_for(share))
                      : std::uint16_t{0};
}

/// Switches the beam on at rest if M3 requires it: in a dwell, or for a dot in G1 to G3. The beam
/// is switched off before the motion that was planned in this cycle begins.
void Machine::attend_rest_light(std::int32_t elapsed_us) {
  if (!motion_.drained()) rest_light_.renew();
  const std::uint16_t light =
      rest_light_.pass(elapsed_us, may_light_at_rest() ? duty_at_rest() : std::uint16_t{0});
  if (light != 0) rest_light_.arm();
  tool_.light_at_rest(light);
  if (light == 0) rest_light_.disarm();
}

MotorEnable::Need Machine::motor_need() const {
  if (!motion_.drained() || !side_.at_rest() || state_.in(Mode::kHome)) {
    return MotorEnable::Need::kMotion;
  }
  return state_.in(Mode::kSleep) ? MotorEnable::Need::kSleep : MotorEnable::Need::kRest;
}

}  // namespace cnc

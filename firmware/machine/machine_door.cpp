#include "firmware/machine/machine.hpp"

namespace cnc {

/// Motion is held, a beam is dark at once; spindle and coolant go off when all
/// stands still. A door opened again while resuming starts anew.
void Machine::safety_door() {
  if (state_.in(Mode::kHome)) return raise_alarm(Alarm::kHomingDoor);
  const bool jogging = state_.in(Mode::kJog) || state_.in(Mode::kJogEnding);
  const bool reopened = state_.in(Mode::kDoor) && door_stage_ > DoorStage::kStopped;
  if (!reopened && !state_.take(Event::kDoor)) return;
  restarting_ = false;
  door_ends_jog_ = jogging;
  door_stage_ = DoorStage::kStopping;
  motion_.halt();
  if (tool_.is_laser()) tool_.suspend(true);
}

void Machine::attend_door() {
  switch (door_stage_) {
    case DoorStage::kStopping:
      if (!at_rest()) return;
      if (door_ends_jog_) drop_jog();
      tool_.suspend(true);
      coolant_.suspend(true);
      door_stage_ = DoorStage::kStopped;
      return;
    case DoorStage::kStopped:
      return;
    case DoorStage::kSpindle:
      if (!restart_dwell_.over()) return;
      coolant_.suspend(false);
      if (coolant_.wanted() != gcode::Coolant{}) {
        restart_dwell_.start(settings_.get(setting::kCoolantRestoreDelay));
      }
      door_stage_ = DoorStage::kCoolant;
      return;
    case DoorStage::kCoolant:
      if (restart_dwell_.over()) restart();
      return;
  }
}

void Machine::resume_from_door() {
  if (door_stage_ != DoorStage::kStopped || inputs().door) return;
  tool_.suspend(false);
  if (tool_turns()) restart_dwell_.start(settings_.get(setting::kSpindleRestoreDelay));
  door_stage_ = DoorStage::kSpindle;
}

std::uint8_t Machine::door_substate() const {
  switch (door_stage_) {
    case DoorStage::kStopping:
      return 2;
    case DoorStage::kStopped:
      return inputs().door ? 1 : 0;
    default:
      return 3;
  }
}

}  // namespace cnc

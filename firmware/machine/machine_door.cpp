#include "firmware/machine/machine.hpp"
#include "planner/base/units.hpp"

namespace cnc {

/// Holds the motion and switches a beam off immediately. The further stages follow at rest. If the
/// door opens again during resumption, the stages restart.
void Machine::safety_door() {
  if (tool_change_.open()) return stop_in_tool_change();
  if (state_.in(Mode::kHome)) return raise_alarm(Alarm::kHomingDoor);
  const bool jogging = state_.in(Mode::kJog) || state_.in(Mode::kJogEnding);
  const bool reopened = state_.in(Mode::kDoor) && door_.is_on_way_back();
  if (!reopened && !state_.take(Event::kDoor)) return;
  if (!reopened) door_.come_back();
  resumption_.cancel();
  door_.open(jogging);
  motion_.halt();
  side_.halt();
  if (!tool_.is_laser()) return;
  tool_.suspend(true);
  if (!reopened) gap_.begin();
}

/// Returns whether the door is stopping a jog. No further line is accepted meanwhile, because the
/// position at which the next line starts is unknown until the axes are at rest.
bool Machine::door_stops_jog() const {
  return state_.in(Mode::kDoor) && door_.stage() == DoorStage::kStopping && door_.ends_jog();
}

/// Runs the stages of the door. Each stage waits for the end of its motion or its delay, and then
/// begins the next stage.
void Machine::attend_door() {
  if (door_.stage() == DoorStage::kStopped) return;
  if (!motion_.at_rest() || !side_.at_rest() || !resumption_.over()) return;
  switch (door_.stage()) {
    case DoorStage::kStopping:
      if (door_.ends_jog()) drop_jog();
      return pull_out();
    case DoorStage::kPullOut:
      return park();
    case DoorStage::kPark:
      door_.go_to(DoorStage::kStopped);
      return;
    case DoorStage::kStopped:
      return;
    case DoorStage::kUnpark:
      return restore_spindle();
    case DoorStage::kSpindle:
      return restore_coolant();
    case DoorStage::kCoolant:
      door_.go_to(DoorStage::kPlunge);
      if (door_.is_away()) {
        trip_to(door_.places().from, setting::kParkingPullOutRate, tool_.command_for(true));
      }
      return;
    case DoorStage::kPlunge:
      door_.come_back();
      return end_door();
  }
}

/// Ends the last door stage and resumes. If a part of the path stays uncut, the machine waits in a
/// hold until the operator resumes.
void Machine::end_door() {
  if (!gap_.end()) return restart();
  static_cast<void>(state_.take(Event::kStay));
}

/// Sets the plan back to the point where a blocked beam went off, and sets the noted progress of
/// the program to this point.
void Machine::find_gap() {
  if (!gap_.opens()) return;
  gap_.find();
  if (gap_.any()) progress_.note(gap_.place());
}

/// Moves the parking axis out of the work while the spindle still turns.
void Machine::pull_out() {
  door_.go_to(DoorStage::kPullOut);
  side_.begin(door_.is_away() || gap_.any() ? side_.place() : motion_.motor_place());
  find_gap();
  if (door_.is_away() || !parks()) return;
  const std::size_t axis = parking_axis();
  const Coordinate here = set_up_.limits().scale[axis].place_of(side_.place()[axis].nearest_step());
  const Coordinate target = from_mm(settings().get(setting::kParkingTarget));
  if (here >= target) return;
  const Coordinate out = here + from_mm(settings().get(setting::kParkingPullOut));
  const auto pulled_out = set_up_.limits().scale[axis].steps_at(out < target ? out : target);
  const auto parked = set_up_.limits().scale[axis].steps_at(target);
  if (!pulled_out || !parked) return;
  door_.leave({.from = side_.place()[axis], .pulled_out = *pulled_out, .parked = *parked});
  trip_to(*pulled_out, setting::kParkingPullOutRate, tool_.command_for(true));
}

void Machine::park() {
  tool_.suspend(true);
  coolant_.suspend(true);
  door_.go_to(DoorStage::kPark);
  if (door_.is_away()) trip_to(door_.places().parked, setting::kParkingRate, {});
}

void Machine::resume_from_door() {
  if (door_.stage() != DoorStage::kStopped || inputs().door) return;
  door_.go_to(DoorStage::kUnpark);
  if (door_.is_away()) trip_to(door_.places().pulled_out, setting::kParkingRate, {});
  if (gap_.any()) side_.go(motion_.motor_place(), 0.0F, {});
  attend_door();
}

void Machine::restore_spindle() {
  door_.go_to(DoorStage::kSpindle);
  tool_.suspend(false);
  if (tool_turns()) resumption_.wait(settings().get(setting::kSpindleRestoreDelay));
}

void Machine::restore_coolant() {
  door_.go_to(DoorStage::kCoolant);
  coolant_.suspend(false);
  if (coolant_.wanted() == gcode::Coolant{}) return;
  resumption_.wait(settings().get(setting::kCoolantRestoreDelay));
}

std::size_t Machine::parking_axis() const {
  return static_cast<std::size_t>(settings().get(setting::kParkingAxis));
}

/// Returns whether the parking axis is used: $41 is on, its position is known, and the tool is a
/// spindle. A beam need not be retracted from the work.
bool Machine::parks() const {
  const bool known = (homed() >> parking_axis() & 1U) != 0;
  return settings().get(setting::kParking) != 0.0F && known && !tool_.is_laser();
}

void Machine::trip_to(StepPosition place, std::uint16_t rate, const motion::BeamCommand& beam) {
  side_.go(parking_axis(), place, settings().get(rate) / kSecondsPerMinute, beam);
}

}  // namespace cnc

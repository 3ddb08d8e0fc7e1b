#include "firmware/machine/machine.hpp"
#include "planner/gcode/kerf_condition.hpp"

/// Compensated motion: elements go through the compensator before they are planned.
namespace cnc {

using gcode::CutterSide;

/// Returns whether there is free space for another element of the programmed path.
bool Machine::has_room() {
  if (!drive_rest()) return false;
  if (!compensated_.compensates()) return state_.in(Mode::kCheck) || motion_.has_room();
  // After a fault, the rest of the line is dropped together with the motion in the compensator.
  if (news_.path_fault) return false;
  give_out();
  if (!compensated_.active()) return state_.in(Mode::kCheck) || motion_.has_room();
  return compensated_.has_room();
}

bool Machine::waits_for_g40() const {
  return compensated_.active() && actions_.empty() && compensated_.has_room();
}

/// Returns the end position of the programmed path so far. The next motion begins there.
const Position& Machine::target() const {
  const bool apart = compensated_.active() || compensated_.beside() || state_.in(Mode::kCheck);
  return apart ? compensated_.programmed() : motion_.target();
}

bool Machine::follows_kerf() const { return settings().get(setting::kKerfControl) != 0.0F; }

/// Sets whether the motors correct the following motion for the change of the kerf with the speed.
/// Returns false if the setting must wait for standstill.
bool Machine::set_kerf_control(const gcode::CutterCompensation& wanted) {
  const bool follows = wanted.by_kerf && follows_kerf() && !state_.in(Mode::kCheck);
  if (!follows && !motion_.follows_kerf()) return true;
  if (!standstill()) return false;
  motion_.follow_kerf(nullptr);
  if (!follows) return true;
  const gcode::ModalState& modal = interpreter_.state();
  // The table has a kerf for this condition, because the interpreter has accepted the line.
  motion_.follow_kerf(
      &compensated_.course_from(gcode::kerf_condition(modal, interpreter_.options())));
  return true;
}

/// Returns the beam command for a motion. On a path that is compensated by the kerf, and on its
/// exit, the power follows the speed, also under M3. Otherwise the kerf would change with the
/// speed.
motion::BeamCommand Machine::beam_for(bool rapid) const {
  if (tool_change_.open()) return {};  // In a tool change, beam and spindle are off.
  motion::BeamCommand beam = tool_.command_for(rapid);
  if (!rapid && compensated_.by_kerf() && !follows_kerf()) beam.follows_speed = true;
  return beam;
}

bool Machine::set_compensation(const gcode::Action& action) {
  if (action.compensation.side != CutterSide::kOn) {
    // With a width of 0 (D0 without a tool), the programmed path is driven.
    if (action.compensation.width_mm <= 0.0F) return true;
    if (!set_kerf_control(action.compensation)) return false;
    compensated_.set(action.compensation, action.plane);
    return true;
  }
  compensated_.cancel();
  give_out();
  if (!compensated_.active()) return true;
  if (!compensated_.has_room()) return false;
  if (const auto fault = compensated_.end()) {
    refuse_path(*fault);
    return false;
  }
  give_out();
  return !compensated_.active();
}

/// Drives the exit: the first motion in the plane after G40, from the end of the compensated path
/// to the end of this motion. If the straight line would cut into the corner at its start, the tool
/// first goes around the corner. A motion to the present programmed position is an exit, too. Axes
/// outside the plane may move before the exit, for example to lift a tool. Returns false if the
/// exit must wait or was refused.
bool Machine::leave_path(const gcode::Action& action) {
  const auto refuse = [this](compensation::Fault fault) {
    fault.line = interpreter_.state().line_number;
    refuse_path(fault);
    return false;
  };
  const bool rapid = action.kind == gcode::ActionKind::kRapid;
  if (!rapid && action.kind != gcode::ActionKind::kLine) {
    return refuse(compensated_.refuse_to_leave());
  }
  if (compensated_.stays_beside(action.end)) return true;
  if (!drive_rest() || !(state_.in(Mode::kCheck) || motion_.has_room())) return false;
  if (const auto fault = compensated_.leave(action.end, rapid)) return refuse(*fault);
  path::PathItem turn;
  const bool turns = compensated_.take(turn) && !state_.in(Mode::kCheck);
  if (turns) static_cast<void>(drive(turn));
  return true;
}

/// Passes an item to the compensator if it is the entry or part of the compensated path. Drives
/// motion before the entry without an offset. In check mode, motion without compensation is passed
/// to this function, too: only the programmed position is updated.
void Machine::append_beside(path::PathItem& item) {
  const PathElement& element = item.request.element;
  if (element.start == element.end) return;
  if (!compensated_.begin_with(element)) return drive_apart(item);
  if (!compensated_.active()) return compensated_.stand_at(element.end);
  actions_.forget_outputs();
  // A later call of give_out() drives the element: by has_room() for the next element, or in the
  // next cycle.
  if (const auto fault = compensated_.put(item)) refuse_path(*fault);
}

/// Drives an item without an offset. If the machine is at the offset from the programmed path, only
/// axes outside the plane move.
void Machine::drive_apart(path::PathItem& item) {
  compensated_.move_apart(item.request.element);
  if (!state_.in(Mode::kCheck) && drive(item)) actions_.forget_outputs();
}

/// Takes elements from the compensator and plans them while the planner has free space. In check
/// mode the elements are dropped.
void Machine::give_out() {
  path::PathItem item;
  const auto room = [this] { return drive_rest() && motion_.has_room(); };
  while (compensated_.active() && (state_.in(Mode::kCheck) || room())) {
    if (!compensated_.take(item)) return;
    if (state_.in(Mode::kCheck)) continue;
    if (!travel_.holds(item.request.element.end)) return stop_for(Alarm::kSoftLimit);
    static_cast<void>(drive(item));
  }
}

/// Refuses the present line and all motion that the compensator holds. Motion that was already
/// planned stops along its path, as with the alarm for soft limits.
void Machine::refuse_path(const compensation::Fault& fault) {
  news_.path_fault = fault;
  if (state_.in(Mode::kCheck)) return raise_alarm(Alarm::kCompensation);
  stop_for(Alarm::kCompensation);
}

/// Cancels an exit that was not driven. The next motion starts at the position of the tool, and not
/// at the end of the programmed path.
void Machine::forget_exit() {
  if (!compensated_.beside()) return;
  interpreter_.set_position(motion_.target());
  compensated_.clear();
}

}  // namespace cnc

#include "firmware/machine/machine.hpp"
#include "planner/gcode/kerf_condition.hpp"

/// Compensated motion: elements go through the compensator before they are planned.
namespace cnc {

using gcode::CutterSide;

/// Returns whether there is free space for another element of the programmed path.
bool Machine::has_room() {
  if (!drive_rest()) return false;
  if (!compensated_.compensates()) return state_.in(Mode::kCheck) || motion_.has_room();
  if (news_.path_fault) return false;  // The rest of the line is dropped with all held motion.
  give_out();
  if (!compensated_.active()) return state_.in(Mode::kCheck) || motion_.has_room();
  return compensated_.has_room();
}

bool Machine::waits_for_g40() const {
  return compensated_.active() && actions_.empty() && compensated_.has_room();
}

/// Returns the end of the programmed path.
const Position& Machine::target() const {
  const bool apart = compensated_.active() || compensated_.beside() || state_.in(Mode::kCheck);
  return apart ? compensated_.programmed() : motion_.target();
}

bool Machine::follows_kerf() const { return settings().get(setting::kKerfControl) != 0.0F; }

/// Sets whether the motors follow the kerf from here on. Returns false while that must wait for
/// standstill.
bool Machine::set_kerf_control(const gcode::CutterCompensation& wanted) {
  const bool follows = wanted.by_kerf && follows_kerf() && !state_.in(Mode::kCheck);
  if (!follows && !motion_.follows_kerf()) return true;
  if (!standstill()) return false;
  motion_.follow_kerf(nullptr);
  if (!follows) return true;
  const gcode::ModalState& modal = interpreter_.state();
  // The table has a kerf for the condition, because the line was read.
  motion_.follow_kerf(
      &compensated_.course_from(gcode::kerf_condition(modal, interpreter_.options())));
  return true;
}

/// Returns the beam command for a motion. On a path compensated by kerf, and on its exit, which
/// begins at that kerf, the power follows the speed, also under M3. Otherwise the kerf would change
/// wherever the speed changes.
motion::BeamCommand Machine::beam_for(bool rapid) const {
  if (tool_change_.open()) return {};  // The output of a spindle is off, too.
  motion::BeamCommand beam = tool_.command_for(rapid);
  if (!rapid && compensated_.by_kerf() && !follows_kerf()) beam.follows_speed = true;
  return beam;
}

bool Machine::set_compensation(const gcode::Action& action) {
  if (action.compensation.side != CutterSide::kOn) {
    // With a width of 0 (D0 without a tool) the path is the programmed one.
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

/// Drives the exit. The first motion after G40 in the plane leads from the compensated path to its
/// own end. It first goes about the corner there if it would cut the corner. A motion to the
/// present programmed position does so, too. Other axes may move before, for example to lift a
/// tool.
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

/// Passes an item to the compensator: the entry, the compensated path or the exit; in check mode
/// also motions without compensation.
void Machine::append_beside(path::PathItem& item) {
  const PathElement& element = item.request.element;
  if (element.start == element.end) return;
  if (!compensated_.begin_with(element)) return drive_apart(item);
  if (!compensated_.active()) return compensated_.stand_at(element.end);
  actions_.forget_outputs();
  // The element is passed on when free space for the next is checked, or in the next cycle.
  if (const auto fault = compensated_.put(item)) refuse_path(*fault);
}

/// Drives an item without an offset. While the machine is off the programmed path, only axes
/// outside the plane move.
void Machine::drive_apart(path::PathItem& item) {
  compensated_.move_apart(item.request.element);
  if (!state_.in(Mode::kCheck) && drive(item)) actions_.forget_outputs();
}

/// Takes elements from the compensator and plans them while there is free space; drops them in
/// check mode.
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

/// Refuses the present line and all held motion. Motion that was already planned stops on its path,
/// as at the end of the travel.
void Machine::refuse_path(const compensation::Fault& fault) {
  news_.path_fault = fault;
  if (state_.in(Mode::kCheck)) return raise_alarm(Alarm::kCompensation);
  stop_for(Alarm::kCompensation);
}

/// Forgets an exit that is not driven: the machine continues from its position, not from the end of
/// the programmed path.
void Machine::forget_exit() {
  if (!compensated_.beside()) return;
  interpreter_.set_position(motion_.target());
  compensated_.clear();
}

}  // namespace cnc

#include "firmware/machine/machine.hpp"

namespace cnc {

using gcode::Action;
using gcode::ActionKind;

namespace {

/// Returns whether an action is a motion along a path, or a change of compensation.
bool is_path(const Action& action) {
  return action.kind <= ActionKind::kProbe || action.kind == ActionKind::kCompensation;
}

}  // namespace

/// Runs an action. Returns whether it is done; otherwise it is run again in the next poll.
bool Machine::run(const Action& action) {
  if (state_.in(Mode::kCheck) && !is_path(action)) return true;
  // G40 itself is not the exit. G40 may take several cycles, until the planner has free space for
  // all motion in the compensator.
  const bool leads_back = action.kind == ActionKind::kCompensation &&
                          action.compensation.side == gcode::CutterSide::kOn;
  if (compensated_.beside() && is_path(action) && !leads_back && !leave_path(action)) return false;
  switch (action.kind) {
    case ActionKind::kRapid:
    case ActionKind::kLine:
    case ActionKind::kArc:
    case ActionKind::kSpline:
      return move(action);
    case ActionKind::kProbe:
      return probe(action);
    case ActionKind::kCompensation:
      return set_compensation(action);
    case ActionKind::kDwell:
      return wait(action.seconds);
    case ActionKind::kSpindleSpeed:
      if (tool_.speed_waits_for_standstill() && !standstill()) return false;
      tool_.set_speed(action.value);
      return true;
    case ActionKind::kSpindle:
      return set_spindle(action.spindle);
    case ActionKind::kCoolant:
      if (!standstill()) return false;
      coolant_.set(action.coolant);
      return true;
    case ActionKind::kToolChange:
      return change_tool(action.number);
    case ActionKind::kOutput:
      return switch_output(action.output);
    case ActionKind::kPause:
      return (action.number == 1 && !switches_.optional_stop) || pause();
    case ActionKind::kEnd:
      return end_program();
    case ActionKind::kToolCentre:
      return switch_tool_centre();
    case ActionKind::kTool:
    case ActionKind::kOffsets:
      return true;
  }
  return true;
}

/// Returns whether the motion has ended. Flushes the plan first, because the caller appends no
/// motion before standstill.
bool Machine::standstill() {
  motion_.flush();
  return motion_.drained();
}

UsualTolerance Machine::usual_tolerance() const {
  return {.path_mm = settings().get(setting::kJunctionDeviation),
          .arc_mm = settings().get(setting::kArcTolerance)};
}

/// Returns the tolerances of the path. Short lines are not welded under G43.4: rotary axes turn the
/// part or the tool, so each part of a line has separate limits.
path::Tolerance Machine::tolerance() const {
  path::Tolerance tolerance = path_tolerance(interpreter_.state().path, usual_tolerance());
  if (tool_centre_.active()) tolerance.weld_mm = 0.0F;
  return tolerance;
}

void Machine::append(const ActionPart& part) {
  const gcode::ModalState& modal = interpreter_.state();
  path::PathItem item{.request = {.element = part.element,
                                  .feed_mm_s = part.feed_mm_s,
                                  .beam = beam_for(part.feed_mm_s <= 0.0F),
                                  .outputs = actions_.outputs(),
                                  .line = {modal.line_number, part.index}},
                      .tolerance = tolerance(),
                      .continues = part.continues};
  if (!part.row.empty()) return append_row(item, part.row);
  if (compensated_.compensates() || state_.in(Mode::kCheck)) return append_beside(item);
  if (compensated_.beside()) return drive_apart(item);
  compensated_.end_exit();  // The exit was the last motion for which by_kerf() had to stay true.
  if (drive(item)) actions_.forget_outputs();
}

/// Returns whether a line with several powers (a row of pixels) may become one element. The tool
/// must be on. Compensation, re-entry, check mode and a tool change require the pixels as separate
/// elements.
bool Machine::takes_rows() const {
  return tool_.mode() != gcode::SpindleMode::kOff && !tool_change_.open() &&
         !compensated_.compensates() && !compensated_.beside() && !state_.in(Mode::kCheck) &&
         !progress_.reentry().active() && !compensated_.by_kerf();
}

void Machine::append_row(path::PathItem& item, std::span<const float> speeds) {
  const auto appended = motion_.append_row(item, tool_.powers_of(speeds));
  CNC_ASSERT(appended.ok());  // No error is possible, for the reasons in drive().
  if (appended.value()) actions_.forget_outputs();
  tool_.set_speed(speeds.back());
}

/// Appends an item to the plan. Returns whether it moves an axis.
bool Machine::drive(path::PathItem& item) {
  if (progress_.reentry().active() && !tool_change_.open()) darken_until_place(item);
  const auto appended = motion_.append(item);
  // No error is possible: the interpreter keeps targets within the range of the motors, and
  // ActionElements divides arcs.
  CNC_ASSERT(appended.ok());
  return appended.value();
}

/// Appends elements of a motion while the planner has free space, and evaluates at most the spline
/// points of one cycle. Returns whether all elements were appended.
bool Machine::move(const Action& action) {
  ActionElements& elements = actions_.elements();
  if (!elements.active()) {
    elements.begin(action,
                   target(),
                   spline_tolerance(interpreter_.state().path, usual_tolerance()),
                   tool_centre_.active() ? tool_centre_.parts_of(target(), action.end) : 1,
                   takes_rows());
  }
  while (!elements.done()) {
    if (!has_room() || !actions_.work()) return false;
    const std::size_t pixels = elements.pixels();
    if (pixels > 0 && !motion_.takes_row(pixels)) return false;
    const ActionPart part = elements.next();
    if (part.power_s) tool_.set_speed(*part.power_s);
    append(part);
  }
  elements.clear();
  return true;
}

bool Machine::dwell(float seconds) { return standstill() && actions_.dwell(seconds); }

/// Runs a dwell (G4). Under M3 the beam may be on during the dwell. Returns whether the dwell is
/// over.
bool Machine::wait(float seconds) {
  const bool begins = !actions_.is_dwelling();
  const bool over = dwell(seconds);
  if (over) {
    rest_light_.end();
  } else if (begins && actions_.is_dwelling()) {
    rest_light_.ask(RestLight::Wish::kDwell);
  }
  return over;
}

/// Sets the mode of the tool. If a spindle starts or reverses, waits for $394. Returns whether the
/// change is complete.
bool Machine::set_spindle(gcode::SpindleMode mode) {
  if (!standstill()) return false;
  if (!actions_.is_dwelling()) {
    const bool same = mode == tool_.mode();
    tool_.set_mode(mode);
    rest_light_.renew();
    if (mode == gcode::SpindleMode::kConstant) rest_light_.ask(RestLight::Wish::kDot);
    if (same || !tool_turns()) return true;
  }
  return dwell(settings().get(setting::kSpindleOnDelay));
}

bool Machine::switch_output(const gcode::OutputChange& change) {
  const std::uint16_t level = to_full_scale(change.value);
  if (!change.with_motion) {
    if (change.analog) {
      outputs_.set_analog_output(change.number, level);
    } else {
      outputs_.set_digital(change.number, level != 0);
    }
    return true;
  }
  // A block can contain only one analog change. If a change of another channel is waiting, that
  // change is output at standstill.
  if (change.analog && actions_.changes_other_analog(change.number)) {
    if (!standstill()) return false;
    const motion::OutputChanges& next = actions_.outputs();
    outputs_.set_analog_output(next.analog_channel, next.analog_value);
  }
  actions_.add_output(change, level);
  return true;
}

/// Pauses once all earlier motion has ended. Returns whether the operator has resumed.
bool Machine::pause() {
  if (!standstill()) return false;
  if (!actions_.is_paused()) {
    actions_.pause();
    static_cast<void>(state_.take(Event::kHold));
  }
  if (!state_.in(Mode::kFree)) return false;
  actions_.end_pause();
  return true;
}

/// Waits, with the tool suspended, until the operator has changed the tool. Does not wait if $341
/// is not 0. Returns whether the change is complete.
bool Machine::change_tool(std::uint32_t tool) {
  if (settings().get(setting::kToolChange) != 0.0F) return true;
  if (!standstill()) return false;
  if (!actions_.is_paused()) {
    if (!state_.take(Event::kTool)) return false;  // The tool change waits for the end of a hold.
    actions_.pause();
    tool_change_.want(tool);
    tool_.suspend(true);
  }
  if (!state_.in(Mode::kFree)) return false;
  actions_.end_pause();
  return true;
}

bool Machine::end_program() {
  if (!standstill()) return false;
  if (progress_.reentry().active()) {
    stop_for(Alarm::kPlaceNotMet);
    return true;
  }
  end_tool_centre();
  forget_exit();
  set_overrides({});
  tool_.off();
  coolant_.reset();
  progress_.forget();
  rest_light_.forget_program();
  news_.program_ended.raise();
  return true;
}

}  // namespace cnc

#include <algorithm>

#include "firmware/machine/machine.hpp"

namespace cnc {

using gcode::Action;
using gcode::ActionKind;

namespace {

/// Motion along a path, or beside it from now on.
bool is_path(const Action& action) {
  return action.kind <= ActionKind::kProbe || action.kind == ActionKind::kCompensation;
}

std::uint16_t to_full_scale(float share) {
  const float legal = share < 0.0F ? 0.0F : (share > 1.0F ? 1.0F : share);
  return static_cast<std::uint16_t>(legal * motion::kFullOutput + 0.5F);
}

}  // namespace

/// True when the action is done; false to be asked again at the next poll.
bool Machine::run(const Action& action) {
  if (state_.in(Mode::kCheck) && !is_path(action)) return true;
  // G40 itself goes on over several turns while there is no room for all that was held.
  const bool leads_back = action.kind == ActionKind::kCompensation &&
                          action.compensation.side == gcode::CutterSide::kOn;
  if (compensator_.beside() && is_path(action) && !leads_back && !leave_path(action)) return false;
  switch (action.kind) {
    case ActionKind::kRapid:
      return move_straight(action, 0.0F);
    case ActionKind::kLine:
      return action.powers.empty() ? move_straight(action, action.feed) : move_in_parts(action);
    case ActionKind::kArc:
      return move_arc(action);
    case ActionKind::kSpline:
      return move_spline(action);
    case ActionKind::kProbe:
      return probe(action);
    case ActionKind::kCompensation:
      return set_compensation(action);
    case ActionKind::kDwell:
      return dwell(action.seconds);
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
      return (action.number == 1 && !optional_stop_) || pause();
    case ActionKind::kEnd:
      return end_program();
    case ActionKind::kTool:
    case ActionKind::kOffsets:
      return true;
  }
  return true;
}

/// Whoever waits for it says that nothing comes before.
bool Machine::standstill() {
  motion_.flush();
  return motion_.drained();
}

/// G61 stays within $11, corners and welds together. G64 rounds within its P and welds
/// within its Q; P alone stands for both, and where there is no P it is $11's.
path::Tolerance Machine::path_tolerance() const {
  const gcode::PathControl& control = interpreter_.state().path;
  const float usual = settings_.get(setting::kJunctionDeviation);
  if (control.mode == gcode::PathMode::kStop) return {};
  if (!control.tolerance_mm && !control.naive_tolerance_mm) {
    return path::tolerance_within(usual, settings_.get(setting::kArcTolerance));
  }
  return {.corner_mm = control.tolerance_mm.value_or(usual),
          .weld_mm = control.naive_tolerance_mm.value_or(control.tolerance_mm.value_or(0.0F))};
}

/// @param continues the curve of the element before it
void Machine::append(const PathElement& element, float feed, bool continues, std::size_t part) {
  path::PathItem item{
      .request = {.element = element,
                  .feed_mm_s = feed,
                  .beam = beam_for(feed <= 0.0F),
                  .outputs = with_next_motion_,
                  .line = {interpreter_.state().line_number, static_cast<std::uint32_t>(part)}},
      .tolerance = path_tolerance(),
      .continues = continues};
  if (compensates() || state_.in(Mode::kCheck)) return append_beside(item);
  compensation_.by_kerf = false;  // The exit was the last that has to keep it.
  if (drive(item)) with_next_motion_ = {};
}

/// True when there is anything to move.
bool Machine::drive(path::PathItem& item) {
  if (reentry_.active()) darken_until_place(item);
  const auto appended = motion_.append(item);
  // The interpreter keeps targets inside the motors' range, and arcs are divided.
  CNC_ASSERT(appended.ok());
  return appended.value();
}

bool Machine::move_straight(const Action& action, float feed) {
  if (!has_room()) return false;
  append({.start = target(), .end = action.end}, feed, false);
  return true;
}

/// Equal parts of a line, each with its power, as the planner has room. To the nanometre.
bool Machine::move_in_parts(const Action& action) {
  if (part_ == 0) parts_from_ = target();
  while (part_ < action.powers.size()) {
    if (!has_room()) return false;
    tool_.set_speed(action.powers[part_]);
    ++part_;
    append({.start = target(), .end = end_of_part(action)}, action.feed, false, part_);
  }
  part_ = 0;
  return true;
}

Position Machine::end_of_part(const Action& action) const {
  const auto count = static_cast<std::int64_t>(action.powers.size());
  Position end = action.end;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const std::int64_t way = (action.end[axis] - parts_from_[axis]).nanometres();
    if (way == 0) continue;
    const auto part = static_cast<std::int64_t>(part_);
    end[axis] = parts_from_[axis] + Coordinate{way * part / count};
  }
  return end;
}

/// How far arcs may be from the curve they stand for: Q of G64, or $12.
float Machine::spline_tolerance() const {
  const float naive = interpreter_.state().path.naive_tolerance_mm.value_or(0.0F);
  const float wanted = naive > 0.0F ? naive : settings_.get(setting::kArcTolerance);
  return std::max(wanted, ArcFit::kLeastToleranceMm);
}

/// Arc by arc, as the planner has room, and as many points of the curve as a turn may look at.
bool Machine::move_spline(const Action& action) {
  if (!spline_) {
    spline_.emplace(*action.spline, target(), spline_tolerance());
    spline_arcs_ = 0;
  }
  while (!spline_->done()) {
    if (!has_room() || !spline_->work(spline_points_)) return false;
    append(spline_->next(), action.feed, spline_arcs_ > 0, spline_arcs_);
    ++spline_arcs_;
  }
  spline_.reset();
  return true;
}

/// Element by element, as the planner has room.
bool Machine::move_arc(const Action& action) {
  if (!arc_) {
    arc_.emplace(CentreArc{.start = target(),
                           .end = action.end,
                           .plane = action.plane,
                           .centre = action.centre,
                           .clockwise = action.clockwise,
                           .turns = action.turns});
    arc_index_ = 0;
  }
  while (arc_index_ < arc_->count()) {
    if (!has_room()) return false;
    append(arc_->element(arc_index_), action.feed, arc_index_ > 0, arc_index_);
    ++arc_index_;
  }
  arc_.reset();
  return true;
}

bool Machine::dwell(float seconds) {
  if (!standstill()) return false;
  if (!dwelling_) {
    dwelling_ = true;
    dwell_.start(seconds);
  }
  if (!dwell_.over()) return false;
  dwelling_ = false;
  return true;
}

/// A spindle that starts or turns round is given its time ($394).
bool Machine::set_spindle(gcode::SpindleMode mode) {
  if (!standstill()) return false;
  if (!dwelling_) {
    const bool same = mode == tool_.mode();
    tool_.set_mode(mode);
    if (same || !tool_turns()) return true;
  }
  return dwell(settings_.get(setting::kSpindleOnDelay));
}

bool Machine::switch_output(const gcode::OutputChange& change) {
  const std::uint16_t level = to_full_scale(change.value);
  const auto bit = static_cast<std::uint8_t>(1U << change.number);
  if (!change.with_motion) {
    if (change.analog) {
      outputs_.set_analog_output(change.number, level);
    } else {
      outputs_.set_digital(change.number, level != 0);
    }
    return true;
  }
  motion::OutputChanges& next = with_next_motion_;
  if (!change.analog) {
    next.raise = static_cast<std::uint8_t>(level != 0 ? next.raise | bit : next.raise & ~bit);
    next.lower = static_cast<std::uint8_t>(level != 0 ? next.lower & ~bit : next.lower | bit);
    return true;
  }
  // One analog change fits into a block; a second channel waits for standstill.
  const bool taken = next.analog_channel != motion::OutputChanges::kNoAnalog &&
                     next.analog_channel != change.number;
  if (taken && !standstill()) return false;
  if (taken) outputs_.set_analog_output(next.analog_channel, next.analog_value);
  next.analog_channel = change.number;
  next.analog_value = level;
  return true;
}

/// Holds when all before is done; over when the operator has gone on.
bool Machine::pause() {
  if (!standstill()) return false;
  if (!pause_seen_) {
    pause_seen_ = true;
    static_cast<void>(state_.take(Event::kHold));
  }
  if (!state_.in(Mode::kFree)) return false;
  pause_seen_ = false;
  return true;
}

/// Waits, tool and coolant off, for whoever puts the tool in. $341 may say that
/// there is nobody.
bool Machine::change_tool(std::uint32_t tool) {
  if (settings_.get(setting::kToolChange) != 0.0F) return true;
  if (!standstill()) return false;
  if (!pause_seen_) {
    if (!state_.take(Event::kTool)) return false;  // Held: when that is over.
    pause_seen_ = true;
    tool_wanted_ = tool;
    tool_.suspend(true);
  }
  if (!state_.in(Mode::kFree)) return false;
  pause_seen_ = false;
  return true;
}

bool Machine::end_program() {
  if (!standstill()) return false;
  if (reentry_.active()) {
    stop_for(Alarm::kPlaceNotMet);
    return true;
  }
  forget_exit();
  set_overrides({});
  tool_.off();
  coolant_.reset();
  forget_progress();
  program_ended_ = true;
  program_end_untold_ = true;
  return true;
}

bool Machine::take_program_ended() {
  const bool ended = program_end_untold_;
  program_end_untold_ = false;
  return ended;
}

}  // namespace cnc

#include "firmware/protocol/report_lines.hpp"

#include <array>

#include "planner/base/units.hpp"

namespace cnc {
namespace {

std::string_view motion_word(gcode::MotionMode mode) {
  switch (mode) {
    case gcode::MotionMode::kRapid:
      return "G0";
    case gcode::MotionMode::kLine:
      return "G1";
    case gcode::MotionMode::kArcClockwise:
      return "G2";
    case gcode::MotionMode::kArcCounterClockwise:
      return "G3";
    case gcode::MotionMode::kCubicSpline:
      return "G5";
    case gcode::MotionMode::kQuadraticSpline:
      return "G5.1";
    case gcode::MotionMode::kNurbs:
      return "G5.2";
    case gcode::MotionMode::kProbeContact:
      return "G38.2";
    case gcode::MotionMode::kProbeContactOrNot:
      return "G38.3";
    case gcode::MotionMode::kProbeRelease:
      return "G38.4";
    case gcode::MotionMode::kProbeReleaseOrNot:
      return "G38.5";
    case gcode::MotionMode::kNurbsEnd:
    case gcode::MotionMode::kNone:
      return "G80";
  }
  return "G80";
}

std::string_view plane_word(Plane plane) {
  switch (plane) {
    case Plane::kXY:
      return " G17";
    case Plane::kZX:
      return " G18";
    case Plane::kYZ:
      return " G19";
  }
  return " G17";
}

std::string_view spindle_word(gcode::SpindleMode mode) {
  switch (mode) {
    case gcode::SpindleMode::kConstant:
      return " M3";
    case gcode::SpindleMode::kDynamic:
      return " M4";
    case gcode::SpindleMode::kOff:
      return " M5";
  }
  return " M5";
}

std::string_view coolant_words(const gcode::Coolant& coolant) {
  if (coolant.mist) return coolant.flood ? " M7 M8" : " M7";
  return coolant.flood ? " M8" : " M9";
}

/// Writes the words of the cutter compensation. Writes nothing for G40, because senders do not
/// require it.
void put_compensation(Reply& reply, const gcode::CutterCompensation& wanted, bool inches) {
  if (wanted.side == gcode::CutterSide::kOn) return;
  const bool left = wanted.side == gcode::CutterSide::kLeft;
  if (wanted.by_kerf) {
    reply.text(left ? " G41" : " G42");
    return;
  }
  reply.text(left ? " G41.1 D" : " G42.1 D");
  reply.value(wanted.width_mm / (inches ? kMillimetresPerInch : 1.0F), 0);
}

/// Writes the path mode with its tolerances, because G64 without tolerances would set other
/// tolerances.
void put_path_control(Reply& reply, const gcode::PathControl& path, bool inches) {
  switch (path.mode) {
    case gcode::PathMode::kPath:
      reply.text(" G61");
      return;
    case gcode::PathMode::kStop:
      reply.text(" G61.1");
      return;
    case gcode::PathMode::kBlend:
      break;
  }
  reply.text(" G64");
  const float unit = inches ? kMillimetresPerInch : 1.0F;
  if (path.tolerance_mm) reply.text(" P").value(*path.tolerance_mm / unit, 0);
  if (path.naive_tolerance_mm) reply.text(" Q").value(*path.naive_tolerance_mm / unit, 0);
}

}  // namespace

std::string_view name_of(MachineState state) {
  switch (state) {
    case MachineState::kIdle:
      return "Idle";
    case MachineState::kRun:
      return "Run";
    case MachineState::kHold:
      return "Hold";
    case MachineState::kJog:
      return "Jog";
    case MachineState::kAlarm:
      return "Alarm";
    case MachineState::kDoor:
      return "Door";
    case MachineState::kCheck:
      return "Check";
    case MachineState::kHome:
      return "Home";
    case MachineState::kSleep:
      return "Sleep";
    case MachineState::kTool:
      return "Tool";
  }
  return "Alarm";
}

std::string_view name_of_system(std::size_t index) {
  constexpr std::array<std::string_view, gcode::kCoordinateSystemCount> kNames{
      "G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};
  return kNames[index];
}

void put_places(Reply& reply, const Position& place, const ReportForm& form) {
  for (std::size_t axis = 0; axis < form.axes; ++axis) {
    if (axis > 0) reply.letter(',');
    reply.place(place[axis], form.inches && axis < kLinearAxisCount);
  }
}

/// Writes the modes. F is in the unit of G20 or G21, whichever is active, because these words are
/// part of the line and determine the unit for its reader.
void put_parser_state(Reply& reply, const Machine& machine) {
  const gcode::ModalState& state = machine.interpreter().state();
  const bool inches = state.units == gcode::Units::kInches;
  const float feed = state.feed * kSecondsPerMinute / (inches ? kMillimetresPerInch : 1.0F);
  reply.text("[GC:").text(motion_word(state.motion)).letter(' ');
  reply.text(name_of_system(state.coordinate_system)).text(plane_word(state.plane));
  reply.text(inches ? " G20" : " G21");
  reply.text(state.distance == gcode::DistanceMode::kAbsolute ? " G90" : " G91");
  reply.text(state.feed_mode == gcode::FeedMode::kUnitsPerMinute ? " G94" : " G93");
  put_compensation(reply, state.compensation, inches);
  if (state.tool_centre) reply.text(" G43.4");
  put_path_control(reply, state.path, inches);
  reply.text(spindle_word(machine.tool().mode_now())).text(coolant_words(machine.coolant()));
  reply.text(" T").number(state.tool).text(" F").value(feed, 0);
  reply.text(" S").value(state.spindle_speed, 0).letter(']').end();
}

void put_probe(Reply& reply, const Probe& probe, const ReportForm& form) {
  reply.text("[PRB:");
  put_places(reply, probe.place, form);
  reply.letter(':').letter(probe.success ? '1' : '0').letter(']').end();
}

}  // namespace cnc

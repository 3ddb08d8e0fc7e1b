#include "host-sim/send/approach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "host-sim/job/modal_words.hpp"
#include "planner/gcode/interpreter.hpp"

namespace sim {
namespace {

using cnc::Coordinate;
using cnc::kAxisCount;

constexpr std::size_t kZ = 2;

/// Reads the lines before the approach with the interpreter of the controller, from a given start
/// position of all axes.
class Reading {
 public:
  explicit Reading(Coordinate from) {
    cnc::Position place{};
    place.fill(from);
    interpreter_.set_position(place);
    highest_ = from;
  }

  void read(const JobLine& line) {
    if (line.text.starts_with('$')) return;
    const auto actions = interpreter_.interpret(line.text);
    if (!actions.ok()) {
      std::array<char, 160> words{};
      const std::size_t size = cnc::gcode::describe(actions.error(), words);
      throw std::invalid_argument(
          fmt::format("line {}: {}", line.number, std::string{words.data(), size}));
    }
    highest_ = std::max(highest_, interpreter_.position()[kZ]);
  }

  [[nodiscard]] const cnc::gcode::Interpreter& interpreter() const { return interpreter_; }
  [[nodiscard]] Coordinate place(std::size_t axis) const { return interpreter_.position()[axis]; }
  [[nodiscard]] Coordinate highest() const { return highest_; }

 private:
  cnc::gcode::Interpreter interpreter_{};
  Coordinate highest_{};
};

/// Returns the motion word that the line requires because it relies on the motion mode of an
/// earlier line. G0 and G1 require no word here, because the approach sets them.
std::string motion_of(const cnc::gcode::ModalState& state, const JobLine& line) {
  using cnc::gcode::MotionMode;
  const bool names_it = line.text.find_first_of("Gg$") != std::string::npos;
  const bool moves = line.text.find_first_of("XYZABCxyzabc") != std::string::npos;
  if (names_it || !moves) return "";
  switch (state.motion) {
    case MotionMode::kArcClockwise:
      return "G2";
    case MotionMode::kArcCounterClockwise:
      return "G3";
    case MotionMode::kCubicSpline:
    case MotionMode::kQuadraticSpline:
    case MotionMode::kNurbs:
      throw std::invalid_argument(
          "the line continues a spline: begin at the line with which the spline begins");
    default:
      return "";
  }
}

}  // namespace

Approach approach_to(const JobLines& job, std::size_t index, bool laser) {
  // Two start positions beyond the range of any machine. A result that is different for the two
  // positions depends on the start position.
  const Coordinate here{123'456'789'123};
  const Coordinate there{-198'765'432'198};
  Reading one{here};
  Reading other{there};
  for (std::size_t before = 0; before < index; ++before) {
    const JobLine line = job[before];
    one.read(line);
    other.read(line);
  }
  const auto& interpreter = one.interpreter();
  const cnc::gcode::ModalState& state = interpreter.state();
  if (interpreter.shift().g92_in_use) {
    throw std::invalid_argument(
        "G92 is in use at that line, but its offset was lost: begin at the line that sets it");
  }
  if (state.tool_centre) {
    throw std::invalid_argument(
        "G43.4 is in use at that line, but was lost: begin at the line that sets it");
  }
  std::string over;
  std::string down;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (one.place(axis) == here && other.place(axis) == there) continue;
    if (one.place(axis) != other.place(axis)) {
      throw std::invalid_argument(
          fmt::format("the position of {} at that line depends on the position of the start (G91): "
                      "begin at the start",
                      cnc::kAxisLetters[axis]));
    }
    const Coordinate offset = interpreter.work_offset(static_cast<cnc::Axis>(axis));
    (axis == kZ ? down : over) +=
        fmt::format("{}{}", cnc::kAxisLetters[axis], coordinate_text(one.place(axis) - offset));
  }
  Approach approach{.lines = {}, .motion = motion_of(state, job[index])};
  const auto add = [&](std::string words) {
    approach.lines.push_back({.text = std::move(words), .number = job.number_of(index)});
  };
  add("G21G90G94M5M9");
  add(modes_of(state));
  if (state.tool_length_in_use) {
    add("G43.1Z" + coordinate_text(interpreter.shift().tool_length));
  }
  if (!down.empty()) {
    const Coordinate offset = interpreter.work_offset(cnc::Axis::kZ);
    add("G0Z" + coordinate_text(other.highest() - offset));
  }
  if (!over.empty()) add("G0" + over);
  // A mill plunges with its spindle already on. A beam has to stay off until Z is at its position.
  if (laser && !down.empty()) add("G0" + down);
  add(process_of(state));
  if (!laser && !down.empty()) add((state.feed > 0.0F ? "G1" : "G0") + down);
  add(units_of(state));
  return approach;
}

}  // namespace sim

#include "host-sim/send/approach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string>

#include "planner/base/units.hpp"
#include "planner/gcode/interpreter.hpp"

namespace sim {
namespace {

using cnc::Coordinate;
using cnc::kAxisCount;
using cnc::gcode::ModalState;

constexpr std::size_t kZ = 2;

/// The lines so far, read by the controller's own interpreter, from some place.
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

std::string decimal(Coordinate place) {
  const std::int64_t nanometres = place.nanometres();
  const std::int64_t size = nanometres < 0 ? -nanometres : nanometres;
  return fmt::format("{}{}.{:06}", nanometres < 0 ? "-" : "", size / 1'000'000, size % 1'000'000);
}

std::string path_words(const cnc::gcode::PathControl& path) {
  if (path.mode == cnc::gcode::PathMode::kPath) return "G61";
  if (path.mode == cnc::gcode::PathMode::kStop) return "G61.1";
  std::string words = "G64";
  if (path.tolerance_mm) words += fmt::format("P{}", *path.tolerance_mm);
  if (path.naive_tolerance_mm) words += fmt::format("Q{}", *path.naive_tolerance_mm);
  return words;
}

std::string system_word(std::uint8_t index) {
  constexpr std::uint8_t kPlain = 6;
  return index < kPlain ? fmt::format("G{}", 54 + index)
                        : fmt::format("G59.{}", index - kPlain + 1);
}

std::string plane_word(cnc::Plane plane) {
  switch (plane) {
    case cnc::Plane::kXY:
      return "G17";
    case cnc::Plane::kZX:
      return "G18";
    case cnc::Plane::kYZ:
      return "G19";
  }
  return "G17";
}

/// The modes whose words mean the same whatever the units are.
std::string modes_of(const ModalState& state) {
  return system_word(state.coordinate_system) + plane_word(state.plane) +
         (state.arc_distance == cnc::gcode::DistanceMode::kAbsolute ? "G90.1" : "G91.1") +
         path_words(state.path);
}

/// Feed, output and motion mode: nothing moves any more.
std::string process_of(const ModalState& state) {
  using cnc::gcode::SpindleMode;
  std::string words = state.motion == cnc::gcode::MotionMode::kRapid ? "G0" : "G1";
  if (state.feed > 0.0F) words += fmt::format("F{}", state.feed * cnc::kSecondsPerMinute);
  words += fmt::format("S{}", state.spindle_speed);
  if (state.spindle == SpindleMode::kConstant) words += "M3";
  if (state.spindle == SpindleMode::kDynamic) words += "M4";
  if (state.coolant.mist) words += "M7";
  if (state.coolant.flood) words += "M8";
  return words;
}

/// As the next line means its numbers.
std::string units_of(const ModalState& state) {
  std::string words = state.units == cnc::gcode::Units::kInches ? "G20" : "G21";
  words += state.distance == cnc::gcode::DistanceMode::kAbsolute ? "G90" : "G91";
  return words + (state.feed_mode == cnc::gcode::FeedMode::kUnitsPerMinute ? "G94" : "G93");
}

/// The word of a mode that a line without one goes on with; G0 and G1 are said anyway.
std::string motion_of(const ModalState& state, const JobLine& line) {
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
      throw std::invalid_argument("the line goes on with a spline: begin where that begins");
    default:
      return "";
  }
}

}  // namespace

Approach approach_to(const std::vector<JobLine>& job, std::size_t index, bool laser) {
  // Farther than any machine goes. What differs between them is where it stood.
  const Coordinate here{123'456'789'123};
  const Coordinate there{-198'765'432'198};
  Reading one{here};
  Reading other{there};
  for (const JobLine& line : std::span{job}.first(index)) {
    one.read(line);
    other.read(line);
  }
  const auto& interpreter = one.interpreter();
  const ModalState& state = interpreter.state();
  if (interpreter.shift().g92_in_use) {
    throw std::invalid_argument("G92 is in use there, and was lost: begin where it is set");
  }
  std::string over;
  std::string down;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (one.place(axis) == here && other.place(axis) == there) continue;
    if (one.place(axis) != other.place(axis)) {
      throw std::invalid_argument(
          fmt::format("where {} is there depends on where the machine stood at the start (G91)",
                      cnc::kAxisLetters[axis]));
    }
    const Coordinate offset = interpreter.work_offset(static_cast<cnc::Axis>(axis));
    (axis == kZ ? down : over) +=
        fmt::format("{}{}", cnc::kAxisLetters[axis], decimal(one.place(axis) - offset));
  }
  Approach approach{.lines = {}, .motion = motion_of(state, job[index])};
  const auto add = [&](std::string words) {
    approach.lines.push_back({.text = std::move(words), .number = job[index].number});
  };
  add("G21G90G94M5M9");
  add(modes_of(state));
  if (state.tool_length_in_use) {
    add("G43.1Z" + decimal(interpreter.shift().tool_length));
  }
  if (!down.empty()) {
    const Coordinate offset = interpreter.work_offset(cnc::Axis::kZ);
    add("G0Z" + decimal(other.highest() - offset));
  }
  if (!over.empty()) add("G0" + over);
  // A mill's spindle turns before it plunges; a beam would be lit on the way.
  if (laser && !down.empty()) add("G0" + down);
  add(process_of(state));
  if (!laser && !down.empty()) add((state.feed > 0.0F ? "G1" : "G0") + down);
  add(units_of(state));
  return approach;
}

}  // namespace sim

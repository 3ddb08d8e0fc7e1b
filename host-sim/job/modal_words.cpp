#include "host-sim/job/modal_words.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "planner/base/units.hpp"

namespace sim {

namespace {

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

}  // namespace

std::string coordinate_text(cnc::Coordinate place) {
  const std::int64_t nanometres = place.nanometres();
  const std::int64_t size = nanometres < 0 ? -nanometres : nanometres;
  return fmt::format("{}{}.{:06}", nanometres < 0 ? "-" : "", size / 1'000'000, size % 1'000'000);
}

std::string modes_of(const cnc::gcode::ModalState& state) {
  return system_word(state.coordinate_system) + plane_word(state.plane) +
         (state.arc_distance == cnc::gcode::DistanceMode::kAbsolute ? "G90.1" : "G91.1") +
         path_words(state.path);
}

std::string process_of(const cnc::gcode::ModalState& state) {
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

std::string units_of(const cnc::gcode::ModalState& state) {
  std::string words = state.units == cnc::gcode::Units::kInches ? "G20" : "G21";
  words += state.distance == cnc::gcode::DistanceMode::kAbsolute ? "G90" : "G91";
  return words + (state.feed_mode == cnc::gcode::FeedMode::kUnitsPerMinute ? "G94" : "G93");
}

}  // namespace sim

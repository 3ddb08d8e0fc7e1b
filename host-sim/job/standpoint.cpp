#include "host-sim/job/standpoint.hpp"

#include <fmt/format.h>

#include "firmware/machine/configuration.hpp"
#include "host-sim/job/modal_words.hpp"

namespace sim {
namespace {

std::string words_of_axes(const cnc::Position& position) {
  std::string words;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    words += cnc::kAxisLetters[axis] + coordinate_text(position[axis]);
  }
  return words;
}

void add_tools(const cnc::gcode::StoredPlaces& places, std::vector<std::string>& lines) {
  std::size_t tool = 0;
  for (const auto& row : places.tool_radii) {
    for (const cnc::Coordinate radius : row) {
      ++tool;
      if (radius == cnc::Coordinate{}) continue;
      lines.push_back(fmt::format("G10L1P{}R{}", tool, coordinate_text(radius)));
    }
  }
}

}  // namespace

Standpoint standpoint_of(const cnc::Machine& machine) {
  Standpoint standpoint{
      .settings = machine.settings(), .reader = machine.interpreter(), .homed = machine.homed()};
  cnc::gcode::Options options = standpoint.reader.options();
  // The kerf tables belong to the machine and may change, so that the copied interpreter must not
  // refer to them.
  options.kerf = nullptr;
  standpoint.reader.set_options(options);
  static_cast<void>(
      standpoint.settings.set(cnc::setting::kBlockDelete, options.block_delete ? 1.0F : 0.0F));
  return standpoint;
}

Standpoint standpoint_of(const cnc::Settings& settings) {
  Standpoint standpoint{.settings = settings};
  cnc::gcode::Options options = cnc::gcode_options_from(settings);
  options.block_delete = settings.get(cnc::setting::kBlockDelete) != 0.0F;
  options.full_power_speed = settings.get(cnc::setting::kMaxSpindleSpeed);
  standpoint.reader.set_options(options);
  return standpoint;
}

double in_double(cnc::Coordinate length) {
  constexpr double kNanometre = 1.0e-6;
  return static_cast<double>(length.nanometres()) * kNanometre;
}

Point point_of(const cnc::Position& position) {
  Point point{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    point[axis] = in_double(position[axis]);
  }
  return point;
}

std::vector<std::string> state_lines(const Standpoint& standpoint) {
  const cnc::gcode::Interpreter& reader = standpoint.reader;
  const cnc::gcode::StoredPlaces& places = reader.places();
  std::vector<std::string> lines{"G21G90G94M5M9"};
  for (std::size_t system = 0; system < places.systems.size(); ++system) {
    if (places.systems[system] == cnc::Position{}) continue;
    lines.push_back(fmt::format("G10L2P{}{}", system + 1, words_of_axes(places.systems[system])));
  }
  add_tools(places, lines);
  lines.push_back(modes_of(reader.state()));
  if (reader.state().tool_length_in_use) {
    lines.push_back("G43.1Z" + coordinate_text(reader.shift().tool_length));
  }
  if (reader.shift().g92_in_use) {
    cnc::Position work = reader.position();
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      work[axis] -= reader.work_offset(static_cast<cnc::Axis>(axis));
    }
    lines.push_back("G92" + words_of_axes(work));
  }
  lines.push_back(process_of(reader.state()));
  lines.push_back(units_of(reader.state()));
  return lines;
}

}  // namespace sim

#include "host-sim/send/standpoint_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "host-sim/job/modal_words.hpp"
#include "host-sim/job/setting_line.hpp"
#include "host-sim/measure/program_line.hpp"
#include "host-sim/send/status_field.hpp"

namespace sim {
namespace {

constexpr double kNanometresPerMillimetre = 1.0e6;

/// Reads a position such as `1.000,2.000,…` in mm or inches. Axes that the text lacks keep their
/// value in `position`.
void read_position(std::string_view text, bool inches, cnc::Position& position) {
  for (std::size_t axis = 0; axis < cnc::kAxisCount && !text.empty(); ++axis) {
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || !std::isfinite(value)) return;
    if (inches && axis < cnc::kLinearAxisCount) value *= kMillimetresPerInch;
    const cnc::Coordinate read{std::llround(value * kNanometresPerMillimetre)};
    if (read.in_range()) position[axis] = read;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.starts_with(',')) return;
    text.remove_prefix(1);
  }
}

/// Returns whether a mode affects the path of a program. `[GC:` also has modes without effect on
/// the path, such as M and F.
bool decides_path(std::string_view word) {
  constexpr std::array<std::string_view, 17> kWords{"G0",
                                                    "G1",
                                                    "G17",
                                                    "G18",
                                                    "G19",
                                                    "G20",
                                                    "G21",
                                                    "G90",
                                                    "G91",
                                                    "G90.1",
                                                    "G91.1",
                                                    "G93",
                                                    "G94",
                                                    "G61",
                                                    "G64",
                                                    "G61.1",
                                                    "G40"};
  return std::ranges::find(kWords, word) != kWords.end() || word.starts_with("G5");
}

void interpret(cnc::gcode::Interpreter& reader, const std::string& line) {
  // Another controller may report words that the interpreter refuses.
  static_cast<void>(reader.interpret(line).ok());
}

}  // namespace

std::vector<JobLine> StandpointReading::questions() {
  return {{.text = "$$"}, {.text = "$#"}, {.text = "$G"}};
}

void StandpointReading::read(std::string_view line) {
  if (line.starts_with('<')) return read_status(line);
  if (line.starts_with('$')) return read_setting(line);
  constexpr std::string_view kModes = "[GC:";
  if (line.starts_with(kModes)) {
    modes_ = line.substr(kModes.size(), line.rfind(']') - kModes.size());
    return;
  }
  if (line.starts_with('[')) read_place(line);
}

void StandpointReading::read_setting(std::string_view line) {
  try {
    const SettingChange change = parse_setting(line, "");
    if (!cnc::find_setting(change.number)) return;
    static_cast<void>(settings_.set(change.number, change.value).ok());
    if (change.number == cnc::setting::kBlockDelete) block_delete_ = change.value != 0.0F;
  } catch (const std::invalid_argument&) {
    // The line is no setting.
  }
}

/// Reads an offset such as `[G54:1.000,2.000,3.000]` or `[TLO:0.000]`.
void StandpointReading::read_place(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return;
  const std::string_view name = line.substr(1, colon - 1);
  const std::string_view value = line.substr(colon + 1);
  const bool inches = settings_.get(cnc::setting::kReportInches) != 0.0F;
  constexpr std::array<std::string_view, 9> kSystems{
      "G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};
  const auto* const system = std::ranges::find(kSystems, name);
  if (system != kSystems.end()) {
    const auto index = static_cast<std::size_t>(system - kSystems.begin());
    if (index < places_.systems.size()) read_position(value, inches, places_.systems[index]);
  }
  if (name == "G28") read_position(value, inches, places_.g28);
  if (name == "G30") read_position(value, inches, places_.g30);
  if (name == "G92") read_position(value, inches, g92_);
  if (name == "TLO") {
    cnc::Position lengths{};
    read_position(value, inches, lengths);
    // Otherwise the text has one value for each axis.
    const bool one = value.find(',') == std::string_view::npos;
    tool_length_ = lengths[one ? 0 : 2];
  }
}

void StandpointReading::read_status(std::string_view line) {
  const bool inches = settings_.get(cnc::setting::kReportInches) != 0.0F;
  if (const auto place = status_field(line, "|MPos:")) read_position(*place, inches, position_);
  if (const auto homed = status_field(line, "|H:")) {
    const std::string_view mask = homed->substr(std::min(homed->find(',') + 1, homed->size()));
    unsigned axes = 0;
    std::from_chars(mask.data(), mask.data() + mask.size(), axes);
    homed_ = static_cast<std::uint8_t>(axes);
    const auto pins =
        status_field(line, "|Pn:");  // Only Kerfline's full report includes block delete.
    block_delete_ = pins && pins->find('L') != std::string_view::npos;
  }
}

Standpoint StandpointReading::standpoint() const {
  cnc::Settings settings = settings_;
  static_cast<void>(settings.set(cnc::setting::kBlockDelete, block_delete_.value_or(false)));
  Standpoint standpoint = standpoint_of(settings);
  standpoint.homed = homed_;
  cnc::gcode::Interpreter& reader = standpoint.reader;
  reader.set_places(places_);
  reader.set_position(position_);
  std::string_view rest = modes_;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, end);
    if (decides_path(word)) interpret(reader, std::string{word});
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  const bool inches = reader.state().units == cnc::gcode::Units::kInches;
  const bool incremental = reader.state().distance == cnc::gcode::DistanceMode::kIncremental;
  interpret(reader, "G21G90");
  if (tool_length_ != cnc::Coordinate{}) {
    interpret(reader, "G43.1Z" + coordinate_text(tool_length_));
  }
  if (g92_ != cnc::Position{}) {
    std::string words = "G92";
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      const cnc::Coordinate work =
          position_[axis] - reader.work_offset(static_cast<cnc::Axis>(axis)) - g92_[axis];
      words += cnc::kAxisLetters[axis] + coordinate_text(work);
    }
    interpret(reader, words);
  }
  if (inches) interpret(reader, "G20");
  if (incremental) interpret(reader, "G91");
  return standpoint;
}

}  // namespace sim

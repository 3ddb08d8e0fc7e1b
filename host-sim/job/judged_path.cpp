#include "host-sim/job/judged_path.hpp"

#include <cctype>
#include <optional>
#include <stdexcept>
#include <utility>

#include "firmware/machine/travel.hpp"
#include "host-sim/job/setting_line.hpp"

namespace sim {
namespace {

std::string without_blanks(std::string_view text) {
  std::string kept;
  for (const char c : text) {
    if (c == '(' || c == ';') break;
    if (std::isspace(static_cast<unsigned char>(c)) == 0) {
      kept += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  return kept;
}

/// Returns the axes that letters name, bit i for axis i; empty if one of the letters names no axis.
std::optional<std::uint8_t> axes_of_letters(std::string_view letters) {
  unsigned axes = 0;
  for (const char letter : letters) {
    std::size_t axis = 0;
    while (axis < cnc::kAxisCount && cnc::kAxisLetters[axis] != letter) ++axis;
    if (axis == cnc::kAxisCount) return std::nullopt;
    axes |= 1U << axis;
  }
  return static_cast<std::uint8_t>(axes);
}

}  // namespace

JudgedPath::JudgedPath(const Standpoint& standpoint, PieceSink sink)
    : settings_{standpoint.settings},
      position_{point_of(standpoint.reader.position())},
      travel_{settings_, standpoint.homed, position_},
      sink_{std::move(sink)},
      reading_{settings_, [this](const PathPiece& piece) {
                 position_ = piece.curve.end();
                 travel_.put(piece);
                 sink_(piece);
               }} {
  const cnc::gcode::StoredPlaces& places = standpoint.reader.places();
  reading_.set_position(point_of(places.g28));
  reading_.take(0, "G28.1");
  reading_.set_position(point_of(places.g30));
  reading_.take(0, "G30.1");
  reading_.set_position(position_);
  for (const std::string& line : state_lines(standpoint)) reading_.take(0, line);
}

void JudgedPath::take(std::size_t line, std::string_view text) {
  homed_now_ = false;
  const std::size_t first = text.find_first_not_of(" \t");
  if (first != std::string_view::npos && text[first] == '$') take_statement(text.substr(first));
  reading_.take(line, text);
}

void JudgedPath::take_statement(std::string_view text) {
  const std::string statement = without_blanks(text);
  if (statement.starts_with("$H")) return home(std::string_view{statement}.substr(2));
  if (statement.find('=') == std::string::npos) return;
  try {
    const SettingChange change = parse_setting(statement, "");
    if (!cnc::find_setting(change.number)) return;
    if (settings_.set(change.number, change.value).ok()) travel_.configure(settings_);
  } catch (const std::invalid_argument&) {
    // The exception means that the line is no setting. It is then ignored.
  }
}

void JudgedPath::home(std::string_view letters) {
  const std::optional<std::uint8_t> named = axes_of_letters(letters);
  if (!named || !cnc::has_homing_option(settings_, cnc::homing_option::kEnabled)) return;
  reading_.end();
  const std::uint8_t axes = *named != 0 ? *named : homed_by_cycle(settings_);
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    if ((axes >> axis & 1U) != 0) position_[axis] = homed_position(settings_, axis);
  }
  travel_.home(axes, position_);
  reading_.set_position(position_);
  homed_now_ = true;
}

}  // namespace sim

#include "host-sim/job/setting_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "host-sim/trace/input_file.hpp"

namespace sim {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t comment = text.find_first_of(";#");
  text = text.substr(0, comment);
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

template <typename Number>
bool read_all(std::string_view text, Number& number) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size();
}

/// Returns the range of a setting as text, for example `, 0 to 30000 mm/min`, if a value was out of
/// this range; otherwise an empty text.
std::string range_of(std::uint16_t number, cnc::SettingError error) {
  const bool is_range =
      error == cnc::SettingError::kBelowRange || error == cnc::SettingError::kAboveRange;
  const auto info = is_range ? cnc::find_setting(number) : std::nullopt;
  if (!info) return {};
  const std::string_view unit{info->unit};
  return fmt::format(", {} to {}{}{}", info->least, info->most, unit.empty() ? "" : " ", unit);
}

}  // namespace

SettingChange parse_setting(std::string_view text, std::string place) {
  SettingChange change{.number = 0, .value = 0.0F, .place = std::move(place)};
  const std::size_t equals = text.find('=');
  const bool is_setting = text.starts_with('$') && equals != std::string_view::npos &&
                          read_all(trimmed(text.substr(1, equals - 1)), change.number) &&
                          read_all(trimmed(text.substr(equals + 1)), change.value) &&
                          std::isfinite(change.value);
  if (!is_setting) {
    throw std::invalid_argument(
        fmt::format("{}: `{}` is not a setting of the form $N=value", change.place, text));
  }
  return change;
}

std::vector<SettingChange> read_settings_file(const std::string& file) {
  const std::string whole = read_text(file);
  std::string_view rest = whole;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
  std::vector<SettingChange> changes;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view text = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (text.empty()) continue;
    changes.push_back(parse_setting(text, fmt::format("{}:{}", name_of_input(file), number)));
  }
  if (changes.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: has no line $N=value; omit the option to use the default settings",
                    name_of_input(file)));
  }
  return changes;
}

void apply_settings(const std::vector<SettingChange>& changes, cnc::Machine& machine) {
  for (const SettingChange& change : changes) {
    const auto stored = machine.change_setting(change.number, change.value);
    if (stored.ok()) continue;
    throw std::invalid_argument(fmt::format("{}: ${}={}: {}{}",
                                            change.place,
                                            change.number,
                                            change.value,
                                            cnc::describe(stored.error()),
                                            range_of(change.number, stored.error())));
  }
}

}  // namespace sim

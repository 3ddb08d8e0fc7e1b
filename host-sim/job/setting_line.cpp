#include "host-sim/job/setting_line.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <system_error>

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
  std::ifstream stream{file};
  if (!stream) throw std::system_error(errno, std::generic_category(), file);
  std::vector<SettingChange> changes;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::string_view text = trimmed(line);
    if (text.empty()) continue;
    changes.push_back(parse_setting(text, fmt::format("{}:{}", file, number)));
  }
  return changes;
}

void apply_settings(const std::vector<SettingChange>& changes, cnc::Machine& machine) {
  for (const SettingChange& change : changes) {
    const auto stored = machine.change_setting(change.number, change.value);
    if (stored.ok()) continue;
    throw std::invalid_argument(fmt::format("{}: ${}={:g}: {}",
                                            change.place,
                                            change.number,
                                            change.value,
                                            cnc::describe(stored.error())));
  }
}

std::string read_text(const std::string& file) {
  if (file == "-") return {std::istreambuf_iterator<char>{std::cin}, {}};
  std::ifstream stream{file, std::ios::binary};
  std::string text;
  if (stream) text.assign(std::istreambuf_iterator<char>{stream}, {});
  if (!stream) throw std::system_error(errno, std::generic_category(), file);
  return text;
}

}  // namespace sim

#include "host-sim/cli/value_range.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string>

namespace sim {
namespace {

template <typename Number>
CLI::Validator range(Number least, Number most, const char* unit, const char* kind) {
  const std::string blank = *unit == '\0' ? "" : " ";
  const std::string words = fmt::format("{} to {}{}{}", least, most, blank, unit);
  const auto check = [=](const std::string& text) -> std::string {
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* const end = text.data() + text.size();
    Number value{};
    const auto read = std::from_chars(begin, end, value);
    const bool is_number = read.ec == std::errc{} && read.ptr == end;
    if (!is_number || std::isnan(static_cast<double>(value))) {
      return fmt::format("`{}` is {}; write {}", text, kind, words);
    }
    if (value < least || value > most) return fmt::format("{} is out of range, {}", text, words);
    return {};
  };
  return CLI::Validator{check, words};
}

}  // namespace

CLI::Validator in_range(double least, double most, const char* unit) {
  return range(least, most, unit, "no number");
}

CLI::Validator port_address() {
  const auto check = [](const std::string& text) -> std::string {
    const std::size_t colon = text.rfind(':');
    std::string port = colon == std::string::npos ? text : text.substr(colon + 1);
    const std::string wrong = in_whole_range(0, 65'535)(port);
    return wrong.empty() ? "" : fmt::format("port {}; write PORT or ADDRESS:PORT", wrong);
  };
  return CLI::Validator{check, ""};
}

CLI::Validator in_whole_range(std::int64_t least, std::int64_t most, const char* unit) {
  return range(least, most, unit, "no whole number");
}

}  // namespace sim

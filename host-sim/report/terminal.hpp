#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>

#include "host-sim/report/printable.hpp"

/// Functions that write to standard output and standard error for the user.
///
/// All output goes through these functions; `tests/static/terminal.py` allows no other output in
/// `host-sim`. Thus no byte that a terminal interprets as a command reaches it from a file name, a
/// program, a drawing, a database or a controller. Each function throws std::system_error if the
/// stream refuses the text.
namespace sim::terminal {

/// A type whose values are text that is printed within a line.
template <typename Value>
concept Text = std::convertible_to<const Value&, std::string_view>;

/// Type of the printed form of a value. Text is escaped, including its line ends; all other values
/// are printed unchanged.
template <typename Value>
using Shown = std::conditional_t<Text<Value>, std::string, const Value&>;

template <typename Value>
[[nodiscard]] Shown<Value> shown(const Value& value) {
  if constexpr (Text<Value>) {
    return printable_line(value);
  } else {
    return value;
  }
}

/// Prints complete lines that are composed of texts. Line ends are unchanged. All other bytes that
/// a terminal interprets as commands are escaped.
void print_lines(std::FILE* stream, std::string_view lines);

/// Prints `values` in the format `format`. Each text among `values` stays on one line.
template <typename... Values>
void print(std::FILE* stream,
           fmt::format_string<std::type_identity_t<Shown<Values>>...> format,
           const Values&... values) {
  print_lines(stream, fmt::format(format, shown(values)...));
}

template <typename... Values>
void print(fmt::format_string<std::type_identity_t<Shown<Values>>...> format,
           const Values&... values) {
  print_lines(stdout, fmt::format(format, shown(values)...));
}

/// Prints lines whose parts are already escaped, with colours between the parts.
void print_styled(std::FILE* stream, std::string_view lines);

/// Writes a program, JSON or another file to standard output, byte for byte. If standard output is
/// a terminal, writes it in the same way as print_lines().
void write_data(std::string_view data);

}  // namespace sim::terminal

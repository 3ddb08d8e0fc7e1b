#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>

#include "host-sim/report/printable.hpp"

/// Standard output and standard error as people read them.
///
/// All output goes through these functions; `tests/static/terminal.py` keeps other ways out of
/// `host-sim`. So no byte that a terminal obeys comes from the name of a file, a program, a
/// drawing, a data base or a controller. Each function throws std::system_error where the stream
/// takes no more.
namespace sim::terminal {

/// A text that is a value within a line.
template <typename Value>
concept Text = std::convertible_to<const Value&, std::string_view>;

/// How a value is printed: a text escaped, its line ends too, and all else as it is.
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

/// Prints whole lines composed of texts: their line ends stay, all else that a
/// terminal obeys is escaped.
void print_lines(std::FILE* stream, std::string_view lines);

/// Prints by `format`, of which the texts among `values` are one line each.
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

/// Prints lines whose parts are escaped already, with colours between them.
void print_styled(std::FILE* stream, std::string_view lines);

/// Writes a program, JSON or another file to standard output, byte for byte; to a terminal as
/// print_lines() does.
void write_data(std::string_view data);

}  // namespace sim::terminal

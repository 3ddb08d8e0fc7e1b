#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Millimetres per inch, for programs and reports in inches.
inline constexpr double kMillimetresPerInch = 25.4;

/// One line of a program, split into words that are not interpreted yet.
struct ProgramLine {
  std::vector<int> g;  ///< G numbers in tenths: 382 for G38.2.
  std::vector<int> m;  ///< M numbers.
  /// Values of the letters other than G and M, indexed by letter A…Z.
  std::array<std::optional<double>, 26> values{};
  std::vector<double> powers;       ///< All values of S if the line has several: S1:2:3.
  std::vector<std::string> faults;  ///< Parts of the line that are not valid words.

  [[nodiscard]] std::optional<double> value(char letter) const;
  [[nodiscard]] bool has_g(int tenths) const;
  /// Returns whether the line has a word X, Y, Z, A, B or C.
  [[nodiscard]] bool has_axis_words() const;
};

/// Removes the first line, including its end (CR, LF or CR LF), from a program. Returns the line
/// without its end.
[[nodiscard]] std::string_view take_line(std::string_view& text);

/// Splits a line into words. Comments, white space, control bytes, `%` lines, names of programs
/// (`O1234`, `:1234`) and lines that `/` deletes contain no words. Letters may be lower case, and
/// words may contain spaces.
/// @param block_delete if false, a `/` at the beginning or after N is ignored
[[nodiscard]] ProgramLine take_apart(std::string_view text, bool block_delete = true);

/// Returns whether block delete is on after a line. The lines `$890=0`, `$890=1` and `$B` of a
/// program change it.
[[nodiscard]] bool block_delete_after(std::string_view line, bool before);

}  // namespace sim

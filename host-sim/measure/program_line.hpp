#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Factor for lengths of programs and reports that are in inches.
inline constexpr double kMillimetresPerInch = 25.4;

/// One line of a program, divided into words that are not interpreted yet.
struct ProgramLine {
  std::vector<int> g;                              ///< G numbers in tenths: G38.2 is 382.
  std::vector<int> m;                              ///< M numbers.
  std::array<std::optional<double>, 26> values{};  ///< Values of the other letters, A…Z.
  std::vector<double> powers;                      ///< Values of S, if it has several: S1:2:3.
  std::vector<std::string> faults;                 ///< Texts of the line that are no words.

  [[nodiscard]] std::optional<double> value(char letter) const;
  [[nodiscard]] bool has_g(int tenths) const;
  /// Returns whether the line has any of X Y Z A B C.
  [[nodiscard]] bool has_axis_words() const;
};

/// Removes the first line from a program and returns it. The line's end, CR, LF or CR LF, is
/// removed with it.
[[nodiscard]] std::string_view take_line(std::string_view& text);

/// Divides a line into words. Comments, white space, control bytes, `%` lines, names of programs
/// (`O1234`, `:1234`) and lines that `/` deletes have no words. Letters may be small, and words may
/// have spaces inside.
/// @param block_delete if false, a / at the front or after N means nothing
[[nodiscard]] ProgramLine take_apart(std::string_view text, bool block_delete = true);

/// Returns whether block delete is on after a line: `$890=0`, `$890=1` and `$B` in a program change
/// it.
[[nodiscard]] bool block_delete_after(std::string_view line, bool before);

}  // namespace sim

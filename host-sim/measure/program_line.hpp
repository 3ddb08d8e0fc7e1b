#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Converts lengths of programs and reports that are in inches.
inline constexpr double kMillimetresPerInch = 25.4;

/// One line of a program, taken apart but not yet understood.
struct ProgramLine {
  std::vector<int> g;                              ///< G numbers in tenths: G38.2 is 382.
  std::vector<int> m;                              ///< M numbers.
  std::array<std::optional<double>, 26> values{};  ///< Of the other letters, A…Z.
  std::vector<double> powers;                      ///< Of S, where it has several: S1:2:3.
  std::vector<std::string> faults;                 ///< What is not a word.

  [[nodiscard]] std::optional<double> value(char letter) const;
  [[nodiscard]] bool has_g(int tenths) const;
  /// Any of X Y Z A B C.
  [[nodiscard]] bool has_axis_words() const;
};

/// Takes the first line off a program; its end, CR, LF or CR LF, goes with it.
[[nodiscard]] std::string_view take_line(std::string_view& text);

/// Comments, white space, control bytes, `%` lines, names of programs (`O1234`, `:1234`) and lines
/// that `/` deletes have no words. Letters may be small, and words may have spaces inside.
/// @param block_delete false: a / at the front or after N means nothing
[[nodiscard]] ProgramLine take_apart(std::string_view text, bool block_delete = true);

/// Block delete behind a line: `$890=0`, `$890=1` and `$B` in a program change it.
[[nodiscard]] bool block_delete_after(std::string_view line, bool before);

}  // namespace sim

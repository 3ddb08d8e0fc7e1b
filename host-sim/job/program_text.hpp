#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// A fact about a line of a program that its user should know.
struct LineNote {
  std::size_t line = 0;    ///< Number of the line, from 1.
  std::size_t column = 0;  ///< Column, from 1; 0 when the note concerns the whole line.
  std::string text;
};

/// The program of a file as every tool drives it. It equals the file line for line and column for
/// column. Blanks replace everything that a file may contain but a controller must not get, or must
/// not interpret in its own way.
struct ProgramText {
  std::string text;
  std::vector<LineNote> notes;  ///< Text that was left out, with one note for each kind.
  /// Lines whose check is wrong, or the reason why the file cannot be read. No sender may begin
  /// with a program that has faults.
  std::vector<LineNote> faults;
  bool readable = true;  ///< If false, there is no text.
};

/// Prepares the program of a file. Leaves out a byte order mark, control bytes, and characters that
/// act at once where a controller reads them (`!`, `?`, `~`, a no-break space). Also leaves out
/// correct checks of lines, M110, and everything after M2 or M30, with which a program in a file
/// ends. Comments are unchanged.
///
/// A wrong check stays in its line, so that the controller refuses it as well.
/// @param block_delete lines with / are skipped ($890): an end in such a line ends nothing
[[nodiscard]] ProgramText prepare_program(std::string file, bool block_delete = true);

/// Returns `FILE:LINE:COLUMN: text` of a note, in the format of compilers, without a column if it
/// is 0.
[[nodiscard]] std::string place_and_text(const std::string& file, const LineNote& note);

}  // namespace sim

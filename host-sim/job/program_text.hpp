#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Something about a line of a program that its user should know.
struct LineNote {
  std::size_t line = 0;    ///< From 1.
  std::size_t column = 0;  ///< From 1; 0 when the whole line is meant.
  std::string text;
};

/// A program of a file as every tool drives it: line for line and column
/// for column the file, with blanks in the place of everything that a file may hold and a
/// controller must not get, or must not be left to understand in its own way.
struct ProgramText {
  std::string text;
  std::vector<LineNote> notes;  ///< What was left out; one note for all of a kind.
  /// Lines whose check is wrong, or what keeps the file from being read: no sender may begin with
  /// this program.
  std::vector<LineNote> faults;
  bool readable = true;  ///< Else there is no text.
};

/// Leaves out a byte order mark, control bytes, characters that act at once where a controller
/// reads them (`!`, `?`, `~`, a no-break space), good checks of lines and M110, and all that
/// follows M2 or M30: a program in a file ends there. Comments stay as they are.
///
/// A wrong check stays in its line, so that the controller refuses it as well.
/// @param block_delete lines with / are skipped ($890): an end in one of them ends nothing
[[nodiscard]] ProgramText prepare_program(std::string file, bool block_delete = true);

/// `FILE:LINE:COLUMN: text` of a note, as compilers say it; no column when it is 0.
[[nodiscard]] std::string place_and_text(const std::string& file, const LineNote& note);

}  // namespace sim

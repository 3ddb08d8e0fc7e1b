#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// A note or fault about a line of a program, for the user.
struct LineNote {
  std::size_t line = 0;    ///< Number of the line, from 1.
  std::size_t column = 0;  ///< Column, from 1; 0 if the note concerns the complete line.
  std::string text;
};

/// The text of a program as all tools drive it. Lines and columns are the same as in the file.
/// Blanks replace content that a file may have but a controller must not receive, or would
/// interpret differently.
struct ProgramText {
  std::string text;
  /// Notes about content that was left out, one note for each kind of content.
  std::vector<LineNote> notes;
  /// Faults: lines whose check is wrong, or the reason why the file cannot be read. A program with
  /// faults must not be sent.
  std::vector<LineNote> faults;
  bool readable = true;  ///< False if the file cannot be read; `text` is then empty.
};

/// Returns the program of a file in the form in which it is driven. Leaves out a byte order mark,
/// control bytes, no-break spaces, and characters on which a controller acts immediately (`!`, `?`,
/// `~`). Also leaves out correct checks of lines, M110, and everything after the M2 or M30 that
/// ends the program. Comments stay unchanged.
///
/// A wrong check stays in its line, so that the controller refuses the line, too.
/// @param block_delete true if lines with / are skipped ($890), so that an M2 in such a line does
/// not end the program
[[nodiscard]] ProgramText prepare_program(std::string file, bool block_delete = true);

/// Returns a note as `FILE:LINE:COLUMN: text`, which is the format of compilers; as `FILE:LINE:
/// text` if the column is 0.
[[nodiscard]] std::string place_and_text(const std::string& file, const LineNote& note);

}  // namespace sim

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

/// Finds programs that continue after their end, and files of several programs. Kerfline's
/// controller reads a file from its start to its first M2 or M30. On other controllers a second `%`
/// ends a program, and a second name (`O1234`, `:1234`, `%name`) begins another program. Kerfline
/// also drives the lines that follow such a mark.
class ProgramMarks {
 public:
  /// Reads the next line, which must not begin with a blank. Returns a note if the line is the
  /// first line that another controller would not drive, or would drive only on request.
  [[nodiscard]] std::optional<std::string> take(std::size_t line, std::string_view text);

 private:
  bool has_content_ = false;  ///< True if words of G-code were read.
  bool is_noted_ = false;     ///< True if the note was returned.
  std::size_t end_line_ = 0;  ///< Line of the `%` that follows words of G-code; 0 if there is none.
  std::size_t named_line_ = 0;  ///< Line of the first name of a program; 0 if there is none.
};

}  // namespace sim

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

/// Finds programs that continue after their end, and files of several programs. Kerfline's
/// controller reads a file from its start to its first M2 or M30. On other controllers a second `%`
/// ends a program, and a second name (`O1234`, `:1234`, `%name`) begins another one; Kerfline
/// drives the lines after them.
class ProgramMarks {
 public:
  /// Takes a line without blanks at its front. Returns a note on the first line that another
  /// controller would not drive, or would drive only on request.
  [[nodiscard]] std::optional<std::string> take(std::size_t line, std::string_view text);

 private:
  bool has_content_ = false;    ///< Whether words of G-code were read.
  bool is_noted_ = false;       ///< Whether the lines after the end are noted.
  std::size_t end_line_ = 0;    ///< Line of the `%` after content.
  std::size_t named_line_ = 0;  ///< Line of the first name.
};

}  // namespace sim

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

/// Finds programs that go on behind their end, and files of several programs. The controller reads
/// a file from its start to its first M2 or M30; elsewhere a second `%` ends a program, and a
/// second name (`O1234`, `:1234`, `%name`) begins another one. What comes then is driven here.
class ProgramMarks {
 public:
  /// Takes a line without blanks at its front. Returns a note on the first line of what another
  /// controller would not drive, or would drive on request only.
  [[nodiscard]] std::optional<std::string> take(std::size_t line, std::string_view text);

 private:
  bool has_content_ = false;    ///< Words of G-code.
  bool is_noted_ = false;       ///< The rest behind the end.
  std::size_t end_line_ = 0;    ///< Of the `%` behind content.
  std::size_t named_line_ = 0;  ///< Of the first name.
};

}  // namespace sim

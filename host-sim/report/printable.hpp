#pragma once

#include <string>
#include <string_view>

namespace sim {

/// Returns a text that is safe to print on a terminal. Bytes that a terminal would obey become
/// `\x1B` and the like; the name of a file or an answer of a controller may contain them. Line
/// ends, tabs and letters in UTF-8 are unchanged.
[[nodiscard]] std::string printable(std::string_view text);

/// Returns a text that is safe to print within a line. Line ends and tabs are escaped as well, so
/// that no name of a file looks like a line of its own.
[[nodiscard]] std::string printable_line(std::string_view text);

}  // namespace sim

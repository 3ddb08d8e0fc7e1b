#pragma once

#include <string>
#include <string_view>

namespace sim {

/// Returns a text that is safe to print on a terminal. Bytes that a terminal would interpret as
/// commands become escapes such as `\x1B`. A file name or an answer of a controller may contain
/// such bytes. Line ends, tabs and letters in UTF-8 are unchanged.
[[nodiscard]] std::string printable(std::string_view text);

/// Returns a text that is safe to print within a line. Line ends and tabs are also escaped, so that
/// no file name can look like a separate line.
[[nodiscard]] std::string printable_line(std::string_view text);

}  // namespace sim

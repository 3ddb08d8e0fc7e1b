#pragma once

#include <string>
#include <string_view>

namespace sim {

/// A text as it may go to a terminal: bytes that a terminal would obey, which a name of a file or
/// an answer of a controller may hold, become `\x1B` and the like. Line ends and tabs stay, and so
/// do letters in UTF-8.
[[nodiscard]] std::string printable(std::string_view text);

/// The same for a text within a line: line ends and tabs are escaped as well, so that no name of a
/// file looks like a line of its own.
[[nodiscard]] std::string printable_line(std::string_view text);

}  // namespace sim

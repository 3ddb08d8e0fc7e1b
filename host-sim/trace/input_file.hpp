#pragma once

#include <string>

namespace sim {

/// Returns the name of an input for messages: the file's name, or `standard input` for `-`.
[[nodiscard]] std::string name_of_input(const std::string& file);

/// Returns the complete text of a file, or of standard input for `-`.
///
/// Throws std::system_error with the name of the file if it cannot be read (a folder, a missing
/// file, no permission). Throws std::invalid_argument for an empty standard input and for binary
/// data. An empty file is accepted, because only the reader of the text knows which content is
/// missing.
/// @param may_be_packed whether gzip is also accepted, for an SVGZ, which the reader unpacks
[[nodiscard]] std::string read_text(const std::string& file, bool may_be_packed = false);

/// Returns the complete content of a file that may be binary, or of standard input for `-`. Throws
/// std::system_error with the name of the file if it cannot be read, and std::invalid_argument for
/// an empty standard input.
[[nodiscard]] std::string read_bytes(const std::string& file);

}  // namespace sim

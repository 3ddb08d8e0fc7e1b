#pragma once

#include <string>

namespace sim {

/// Returns the name of an input for messages: the file's name, or `standard input` for `-`.
[[nodiscard]] std::string name_of_input(const std::string& file);

/// Returns the whole text of a file, or of standard input for `-`.
///
/// Throws std::system_error naming the file when it cannot be read (a folder, a missing file, no
/// permission). Throws std::invalid_argument for an empty standard input and for bytes that are no
/// text. An empty file is accepted: the reader of the text knows what is missing.
/// @param may_be_packed whether gzip is accepted as well, for an SVGZ, which the reader unpacks
[[nodiscard]] std::string read_text(const std::string& file, bool may_be_packed = false);

/// Returns the whole content of a file that may be binary, or of standard input for `-`. Throws
/// std::system_error naming the file when it cannot be read, std::invalid_argument for an empty
/// standard input.
[[nodiscard]] std::string read_bytes(const std::string& file);

}  // namespace sim

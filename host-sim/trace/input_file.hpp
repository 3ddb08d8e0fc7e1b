#pragma once

#include <string>

namespace sim {

/// What a text is called in messages: its name, or `standard input` for `-`.
[[nodiscard]] std::string name_of_input(const std::string& file);

/// The whole text of a file, or of standard input for `-`.
///
/// Throws std::system_error naming the file when it cannot be read (a folder, a file that is not
/// there or not permitted), std::invalid_argument for an empty standard input and for bytes that
/// are no text. An empty file is a text: its reader knows what is missing.
/// @param may_be_packed whether gzip is taken, too: an SVGZ, whose reader unpacks it
[[nodiscard]] std::string read_text(const std::string& file, bool may_be_packed = false);

/// The same for a file that may be binary. Throws std::system_error naming it when it cannot be
/// read, std::invalid_argument for an empty standard input.
[[nodiscard]] std::string read_bytes(const std::string& file);

}  // namespace sim

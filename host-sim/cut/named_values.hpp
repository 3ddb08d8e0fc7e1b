#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sim::cut {

/// A text `NAME: key=value, key=value` as people write it on a line of a file or in an option.
struct NamedValues {
  std::string name;
  std::vector<std::pair<std::string, std::string>> values;
  std::string place;  ///< Origin of the text: `FILE:LINE`, or the option.
};

/// Reads one text. Throws std::invalid_argument, which names the place and the required `form`.
[[nodiscard]] NamedValues parse_named_values(std::string_view text,
                                             std::string place,
                                             std::string_view form);

/// Reads one text per line. Blank lines, and lines that begin with `#`, do not count. Throws
/// std::invalid_argument as parse_named_values() does, and for a file without any.
[[nodiscard]] std::vector<NamedValues> read_named_values(const std::string& text,
                                                         const std::string& file,
                                                         std::string_view form);

/// Returns the number that the whole of `text` stands for. Throws std::invalid_argument, which
/// names key and range, for every other text and for numbers out of the range.
[[nodiscard]] double number_from(
    std::string_view key, std::string_view text, double least, double most, const char* unit);

}  // namespace sim::cut

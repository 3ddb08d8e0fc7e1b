#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sim::cut {

/// A text `NAME: key=value, key=value`, as users write it on a line of a file or in an option.
struct NamedValues {
  std::string name;
  std::vector<std::pair<std::string, std::string>> values;
  std::string place;  ///< Origin of the text, for messages: `FILE:LINE`, or the option.
};

/// Reads one text of the form of NamedValues. Throws std::invalid_argument with the place and the
/// required `form` if the text is not valid.
[[nodiscard]] NamedValues parse_named_values(std::string_view text,
                                             std::string place,
                                             std::string_view form);

/// Reads one text of the form of NamedValues from each line. Blank lines, and lines that begin with
/// `#`, are ignored. Throws std::invalid_argument as parse_named_values() does, and for a file
/// without any text.
[[nodiscard]] std::vector<NamedValues> read_named_values(const std::string& text,
                                                         const std::string& file,
                                                         std::string_view form);

/// Returns the number that `text` consists of. Throws std::invalid_argument with the key and the
/// range if `text` is no number or is out of the range.
[[nodiscard]] double number_from(
    std::string_view key, std::string_view text, double least, double most, const char* unit);

}  // namespace sim::cut

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sim::cut {

/// `NAME: key=value, key=value` as people write it on a line of a file, or in an option.
struct NamedValues {
  std::string name;
  std::vector<std::pair<std::string, std::string>> values;
  std::string place;  ///< `FILE:LINE`, or the option.
};

/// Throws std::invalid_argument with the place, saying that it wants the form.
[[nodiscard]] NamedValues parse_named_values(std::string_view text,
                                             std::string place,
                                             std::string_view form);

/// Reads one to a line; blank lines and those that begin with `#` do not count. Throws
/// std::invalid_argument as parse_named_values() does, and for a file without any.
[[nodiscard]] std::vector<NamedValues> read_named_values(const std::string& text,
                                                         const std::string& file,
                                                         std::string_view form);

/// Returns a value that is a number as a whole. Throws std::invalid_argument with key and range for
/// every other text, and for numbers out of the range.
[[nodiscard]] double number_from(
    std::string_view key, std::string_view text, double least, double most, const char* unit);

}  // namespace sim::cut

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sim {

/// The character at the front of a text.
struct Utf8Character {
  std::size_t bytes;    ///< At least 1, so that a loop over the text ends.
  char32_t code_point;  ///< U+FFFD when not valid.
  bool is_valid;        ///< Well-formed UTF-8 (no overlong form, no surrogate).
};

/// @pre !text.empty()
[[nodiscard]] Utf8Character first_character(std::string_view text);

/// Columns that a terminal needs for the text: 0 for combining marks, 2 for
/// East Asian wide characters and emoji, 1 for all else.
[[nodiscard]] std::size_t display_width(std::string_view text);

/// The text filled with spaces up to `width` columns, at its end or its front.
[[nodiscard]] std::string pad_right(std::string_view text, std::size_t width);
[[nodiscard]] std::string pad_left(std::string_view text, std::size_t width);

}  // namespace sim

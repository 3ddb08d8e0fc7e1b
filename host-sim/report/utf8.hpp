#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sim {

/// The first character of a text, with its size.
struct Utf8Character {
  /// Number of bytes of the character; at least 1, so that a loop over the text ends.
  std::size_t bytes;
  char32_t code_point;  ///< Code point; U+FFFD if the bytes are not valid.
  bool is_valid;  ///< Whether the bytes are well-formed UTF-8 (no overlong form, no surrogate).
};

/// Returns the first character of a text.
/// @pre !text.empty()
[[nodiscard]] Utf8Character first_character(std::string_view text);

/// Returns the number of columns that the text fills on a terminal: 0 for combining marks, 2 for
/// East Asian wide characters and emoji, 1 for all other characters.
[[nodiscard]] std::size_t display_width(std::string_view text);

/// Return the text padded with spaces to `width` columns. pad_right() adds the spaces at the end,
/// pad_left() at the beginning.
[[nodiscard]] std::string pad_right(std::string_view text, std::size_t width);
[[nodiscard]] std::string pad_left(std::string_view text, std::size_t width);

}  // namespace sim

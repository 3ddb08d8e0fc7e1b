#pragma once

#include <cstddef>
#include <string_view>

namespace sim::text {

/// A code point of a text in UTF-8.
struct CodePoint {
  char32_t value = 0;
  std::size_t size = 1;  ///< Length of its encoding, in bytes.
};

inline constexpr char32_t kReplacement = 0xFFFD;

/// Returns the code point at the beginning of a text. Returns kReplacement with a length of one
/// byte if the text does not begin with valid UTF-8.
/// @pre the text is not empty
[[nodiscard]] constexpr CodePoint code_point(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80U) return {first, 1};
  const std::size_t size = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
  if (first < 0xC2U || first > 0xF4U || text.size() < size) return {kReplacement, 1};
  char32_t value = first & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {kReplacement, 1};
    value = value << 6U | (byte(i) & 0x3FU);
  }
  return {value, size};
}

}  // namespace sim::text

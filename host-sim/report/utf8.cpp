#include "host-sim/report/utf8.hpp"

#include <array>

namespace sim {
namespace {

constexpr Utf8Character kInvalid{1, 0xFFFD, false};

struct Range {
  char32_t first;
  char32_t last;
};

// The ranges are complete blocks, not single characters. This is sufficient for file names and
// messages.
constexpr std::array<Range, 4> kCombining{
    {{0x0300, 0x036F}, {0x200B, 0x200F}, {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}}};
constexpr std::array<Range, 8> kWide{{{0x1100, 0x115F},
                                      {0x2E80, 0xA4CF},
                                      {0xAC00, 0xD7A3},
                                      {0xF900, 0xFAFF},
                                      {0xFE30, 0xFE6F},
                                      {0xFF00, 0xFF60},
                                      {0x1F300, 0x1F64F},
                                      {0x1F900, 0x1F9FF}}};

template <std::size_t N>
bool is_in(const std::array<Range, N>& ranges, char32_t code_point) {
  for (const Range& range : ranges) {
    if (code_point >= range.first && code_point <= range.last) return true;
  }
  return false;
}

std::size_t sequence_length(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  if (lead >= 0xF0 && lead < 0xF5) return 4;
  return 0;
}

bool is_well_formed(char32_t code_point, std::size_t bytes) {
  constexpr std::array<char32_t, 5> kMin{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code_point >= 0xD800 && code_point <= 0xDFFF;
  return code_point >= kMin[bytes] && code_point <= 0x10FFFF && !is_surrogate;
}

std::size_t width_of(char32_t code_point) {
  if (is_in(kCombining, code_point)) return 0;
  return is_in(kWide, code_point) ? 2 : 1;
}

std::string fill(std::string_view text, std::size_t width) {
  const std::size_t used = display_width(text);
  std::string spaces;
  if (used < width) spaces.resize(width - used, ' ');
  return spaces;
}

}  // namespace

Utf8Character first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t bytes = sequence_length(lead);
  if (bytes == 0 || bytes > text.size()) return kInvalid;
  if (bytes == 1) return {1, lead, true};
  char32_t code_point = lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0U) != 0x80U) return kInvalid;
    code_point = (code_point << 6U) | (next & 0x3FU);
  }
  return is_well_formed(code_point, bytes) ? Utf8Character{bytes, code_point, true} : kInvalid;
}

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    width += width_of(character.code_point);
    text.remove_prefix(character.bytes);
  }
  return width;
}

std::string pad_right(std::string_view text, std::size_t width) {
  return std::string{text} + fill(text, width);
}

std::string pad_left(std::string_view text, std::size_t width) {
  return fill(text, width) + std::string{text};
}

}  // namespace sim

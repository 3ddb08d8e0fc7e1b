#include "host-sim/picture/base64.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace sim::picture {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint32_t kBitsOfDigit = 6;
constexpr std::uint32_t kBitsOfByte = 8;
constexpr std::uint8_t kNoDigit = 0xFF;

/// Returns a table with the value of each character as a digit of base 64.
constexpr std::array<std::uint8_t, 256> values_of_characters() {
  std::array<std::uint8_t, 256> values{};
  for (std::uint8_t& value : values) value = kNoDigit;
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    values.at(static_cast<std::uint8_t>(kDigits[i])) = static_cast<std::uint8_t>(i);
  }
  return values;
}
constexpr std::array<std::uint8_t, 256> kValues = values_of_characters();

}  // namespace

std::optional<std::string> base64_decoded(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t value = 0;
  std::uint32_t bits = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '=') continue;
    const std::uint8_t digit = kValues.at(static_cast<std::uint8_t>(c));
    if (digit == kNoDigit) return std::nullopt;
    value = (value << kBitsOfDigit) | digit;
    bits += kBitsOfDigit;
    if (bits < kBitsOfByte) continue;
    bits -= kBitsOfByte;
    bytes += static_cast<char>((value >> bits) & 0xFFU);
    value &= (1U << bits) - 1U;
  }
  return bytes;
}

std::string base64_encoded(std::string_view bytes) {
  constexpr std::size_t kBytes = 3;
  constexpr std::size_t kDigitsOfBytes = 4;
  std::string text;
  text.reserve((bytes.size() + 2) / kBytes * kDigitsOfBytes);
  for (std::size_t i = 0; i < bytes.size(); i += kBytes) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < kBytes; ++k) {
      const bool is_there = i + k < bytes.size();
      value = (value << kBitsOfByte) | (is_there ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < kDigitsOfBytes; ++k) {
      const std::size_t digit = (value >> (kBitsOfDigit * (kBytes - k))) & 0x3FU;
      text += i + k <= bytes.size() ? kDigits[digit] : '=';
    }
  }
  return text;
}

}  // namespace sim::picture

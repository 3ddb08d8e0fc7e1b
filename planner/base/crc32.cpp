#include "planner/base/crc32.hpp"

#include <array>

namespace cnc {
namespace {

constexpr std::uint32_t kPolynomial = 0xEDB8'8320;
constexpr std::size_t kNibbles = 4;  ///< Of half a word.

/// What a nibble leaves when so many others come after it.
using Remainders = std::array<std::uint32_t, 16>;

constexpr std::array<Remainders, kNibbles> make_tables() {
  std::array<Remainders, kNibbles> tables{};
  for (std::uint32_t i = 0; i < 16; ++i) {
    std::uint32_t remainder = i;
    for (Remainders& table : tables) {
      for (int bit = 0; bit < 4; ++bit) {
        remainder = (remainder >> 1) ^ ((remainder & 1U) != 0 ? kPolynomial : 0U);
      }
      table[i] = remainder;
    }
  }
  return tables;
}

constexpr std::array<Remainders, kNibbles> kTables = make_tables();

/// Of the lowest nibble, with so many behind it.
constexpr std::uint32_t remainder_of(std::uint32_t value, std::size_t behind) {
  return kTables[behind][value & 0xFU];
}

}  // namespace

std::uint32_t Crc32::after_half(std::uint32_t mixed) {
  return (mixed >> 16) ^ remainder_of(mixed, 3) ^ remainder_of(mixed >> 4, 2) ^
         remainder_of(mixed >> 8, 1) ^ remainder_of(mixed >> 12, 0);
}

void Crc32::add(std::byte byte) {
  const std::uint32_t mixed = state_ ^ std::to_integer<std::uint32_t>(byte);
  state_ = (mixed >> 8) ^ remainder_of(mixed, 1) ^ remainder_of(mixed >> 4, 0);
}

void Crc32::add(std::uint32_t word) { state_ = after_half(after_half(state_ ^ word)); }

void Crc32::add(std::span<const std::byte> bytes) {
  const auto at = [&bytes](std::size_t i) { return std::to_integer<std::uint32_t>(bytes[i]); };
  while (bytes.size() >= sizeof(std::uint32_t)) {
    add(at(0) | (at(1) << 8) | (at(2) << 16) | (at(3) << 24));
    bytes = bytes.subspan(sizeof(std::uint32_t));
  }
  for (const std::byte byte : bytes) add(byte);
}

}  // namespace cnc

#include "planner/base/crc32.hpp"

#include <array>

namespace cnc {
namespace {

constexpr std::uint32_t kPolynomial = 0xEDB8'8320;
constexpr std::uint32_t kNibble = 0xF;

constexpr std::array<std::uint32_t, 16> make_table() {
  std::array<std::uint32_t, 16> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t remainder = i;
    for (int bit = 0; bit < 4; ++bit) {
      remainder = (remainder >> 1) ^ ((remainder & 1U) != 0 ? kPolynomial : 0U);
    }
    table[i] = remainder;
  }
  return table;
}

constexpr std::array<std::uint32_t, 16> kTable = make_table();

}  // namespace

void Crc32::add(std::byte byte) {
  state_ ^= std::to_integer<std::uint32_t>(byte);
  state_ = (state_ >> 4) ^ kTable[state_ & kNibble];
  state_ = (state_ >> 4) ^ kTable[state_ & kNibble];
}

void Crc32::add(std::uint32_t word) {
  state_ ^= word;
  for (int nibble = 0; nibble < 8; ++nibble) {
    state_ = (state_ >> 4) ^ kTable[state_ & kNibble];
  }
}

void Crc32::add(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) add(byte);
}

}  // namespace cnc

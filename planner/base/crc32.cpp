#include "planner/base/crc32.hpp"

#include <array>

namespace cnc {
namespace {

constexpr std::uint32_t kPolynomial = 0xEDB8'8320;
/// Number of bits in a digit, the unit of a table look-up: a byte where memory is plenty, a nibble
/// on a controller.
constexpr std::size_t kDigitBits = sizeof(void*) > 4 ? 8 : 4;
constexpr std::size_t kDigits = 4;  ///< Number of digits that a step processes.
constexpr std::size_t kStepBits = kDigits * kDigitBits;

/// CRC remainder of each value of a digit. There is one such table for each number of digits that
/// may follow the digit within a step.
using Remainders = std::array<std::uint32_t, 1U << kDigitBits>;

constexpr std::array<Remainders, kDigits> make_tables() {
  std::array<Remainders, kDigits> tables{};
  for (std::uint32_t i = 0; i < Remainders{}.size(); ++i) {
    std::uint32_t remainder = i;
    for (Remainders& table : tables) {
      for (std::size_t bit = 0; bit < kDigitBits; ++bit) {
        remainder = (remainder >> 1) ^ ((remainder & 1U) != 0 ? kPolynomial : 0U);
      }
      table[i] = remainder;
    }
  }
  return tables;
}

constexpr std::array<Remainders, kDigits> kTables = make_tables();

/// Returns the CRC remainder of one digit of `value`.
/// @param digit number of the digit; 0 is the lowest
/// @param behind number of digits after this digit in the same step
constexpr std::uint32_t remainder_of(std::uint32_t value, std::size_t digit, std::size_t behind) {
  return kTables[behind][(value >> (digit * kDigitBits)) % Remainders{}.size()];
}

}  // namespace

std::uint32_t Crc32::after_step(std::uint32_t mixed) {
  const std::uint32_t moved_down = kStepBits < 32 ? mixed >> (kStepBits % 32) : 0U;
  return moved_down ^ remainder_of(mixed, 0, 3) ^ remainder_of(mixed, 1, 2) ^
         remainder_of(mixed, 2, 1) ^ remainder_of(mixed, 3, 0);
}

void Crc32::add(std::byte byte) {
  const std::uint32_t mixed = state_ ^ std::to_integer<std::uint32_t>(byte);
  if constexpr (kDigitBits == 8) {
    state_ = (mixed >> 8) ^ remainder_of(mixed, 0, 0);
  } else {
    state_ = (mixed >> 8) ^ remainder_of(mixed, 0, 1) ^ remainder_of(mixed, 1, 0);
  }
}

void Crc32::add(std::uint32_t word) {
  state_ = after_step(state_ ^ word);
  if constexpr (kStepBits < 32) state_ = after_step(state_);
}

void Crc32::add(std::span<const std::byte> bytes) {
  const auto at = [&bytes](std::size_t i) { return std::to_integer<std::uint32_t>(bytes[i]); };
  while (bytes.size() >= sizeof(std::uint32_t)) {
    add(at(0) | (at(1) << 8) | (at(2) << 16) | (at(3) << 24));
    bytes = bytes.subspan(sizeof(std::uint32_t));
  }
  for (const std::byte byte : bytes) add(byte);
}

}  // namespace cnc

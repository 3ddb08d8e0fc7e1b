#pragma once

#include <cstdint>

namespace cnc {

/// Returns the upper 64 bits of the product of two 64-bit numbers: a · b / 2^64, rounded down. The
/// controller has no 128-bit integers.
[[nodiscard]] constexpr std::uint64_t multiply_high(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kLow = 0xFFFF'FFFFU;
  const std::uint64_t low_low = (a & kLow) * (b & kLow);
  const std::uint64_t high_low = (a >> 32) * (b & kLow);
  const std::uint64_t low_high = (a & kLow) * (b >> 32);
  const std::uint64_t middle = (low_low >> 32) + (high_low & kLow) + (low_high & kLow);
  return (a >> 32) * (b >> 32) + (high_low >> 32) + (low_high >> 32) + (middle >> 32);
}

}  // namespace cnc

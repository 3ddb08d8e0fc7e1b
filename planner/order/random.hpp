#pragma once

#include <cstdint>

#include "planner/order/precedence.hpp"

namespace cnc::order {

/// Generator of random numbers that are the same on every machine: SplitMix64 (Steele, Lea and
/// Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_{seed} {}

  std::uint64_t bits() {
    state_ += 0x9E37'79B9'7F4A'7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58'476D'1CE4'E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D0'49BB'1331'11EBU;
    return z ^ (z >> 31U);
  }

  /// Returns a random number in [0, 1).
  double unit() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }

  /// Returns a random whole number from 0 to count − 1. @pre count > 0
  Index below(Index count) {
    return static_cast<Index>(((bits() >> 32U) * std::uint64_t{count}) >> 32U);
  }

 private:
  std::uint64_t state_;
};

}  // namespace cnc::order

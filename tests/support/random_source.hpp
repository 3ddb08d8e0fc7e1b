#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace proof {

/// Source of random numbers that are the same with every compiler and library (SplitMix64, Steele
/// and others 2014), which is not true of std::uniform_real_distribution.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_{mix(seed)} {}

  std::uint64_t bits() {
    state_ += 0x9E37'79B9'7F4A'7C15U;
    return mix(state_);
  }

  /// Returns a number in [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  double between(double least, double most) { return least + (most - least) * unit(); }
  /// Returns a number on a logarithmic scale: every factor of ten is equally likely. @pre 0 < least
  /// ≤ most
  double magnitude(double least, double most) {
    return least * std::exp(unit() * std::log(most / least));
  }
  double signed_magnitude(double least, double most) {
    const double size = magnitude(least, most);
    return chance(0.5) ? size : -size;
  }
  /// Returns a whole number in 0…count − 1.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
  bool chance(double probability) { return unit() < probability; }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9U;
    z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EBU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace proof

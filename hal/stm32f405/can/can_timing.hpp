#pragma once

#include <cstdint>

#include "hal/stm32f405/registers.hpp"

namespace hal::stm32f405 {

/// How a bit is cut into quanta of time (RM0090, 32.7.7): one to begin with, `before`
/// until it is looked at, `after` until it ends.
struct CanTiming {
  std::uint32_t prescaler = 0;  ///< Clocks in a quantum, 1 to 1024; 0: no such timing.
  std::uint32_t before = 0;     ///< 1 to 16 quanta.
  std::uint32_t after = 0;      ///< 1 to 8 quanta.

  [[nodiscard]] constexpr bool exists() const { return prescaler != 0; }
  [[nodiscard]] constexpr std::uint32_t quanta() const { return 1 + before + after; }
  /// Where in the bit it is looked at, in thousandths.
  [[nodiscard]] constexpr std::uint32_t sample_point() const {
    return 1000 * (1 + before) / quanta();
  }
  /// Resynchronisation by as much as the bit's end allows: crystals may differ the more.
  [[nodiscard]] constexpr std::uint32_t jump() const { return after < 4 ? after : 4; }
  [[nodiscard]] constexpr Word word() const {
    return (jump() - 1) << 24 | (after - 1) << 20 | (before - 1) << 16 | (prescaler - 1);
  }
};

inline constexpr std::uint32_t kCanSamplePoint = 875;  ///< Thousandths; CiA 301, table 1.

/// The timing of exactly this rate that is looked at nearest to kCanSamplePoint, of
/// equals the finest; none where the clock does not divide.
constexpr CanTiming can_timing(std::uint32_t clock_hz, std::uint32_t bit_rate) {
  CanTiming best;
  std::uint32_t best_distance = 1000;
  if (bit_rate == 0 || clock_hz % bit_rate != 0) return best;
  const std::uint32_t clocks = clock_hz / bit_rate;
  for (std::uint32_t quanta = 25; quanta >= 8; --quanta) {
    if (clocks % quanta != 0 || clocks / quanta > 1024) continue;
    for (std::uint32_t after = 1; after <= 8 && after + 2 <= quanta; ++after) {
      const CanTiming timing{clocks / quanta, quanta - 1 - after, after};
      if (timing.before > 16) continue;
      const std::uint32_t point = timing.sample_point();
      const std::uint32_t distance =
          point > kCanSamplePoint ? point - kCanSamplePoint : kCanSamplePoint - point;
      if (distance >= best_distance) continue;
      best = timing;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace hal::stm32f405

#pragma once

#include <cstdint>

#include "hal/stm32f405/registers.hpp"

namespace hal::stm32f405 {

/// Division of a bit into time quanta (RM0090, 32.7.7): one quantum for synchronisation, `before`
/// quanta until the sample point, and `after` quanta until the end of the bit.
struct CanTiming {
  std::uint32_t prescaler = 0;  ///< Clocks in a quantum, 1 to 1024; 0 if no timing exists.
  std::uint32_t before = 0;     ///< Number of quanta before the sample point, 1 to 16.
  std::uint32_t after = 0;      ///< Number of quanta after the sample point, 1 to 8.

  [[nodiscard]] constexpr bool exists() const { return prescaler != 0; }
  [[nodiscard]] constexpr std::uint32_t quanta() const { return 1 + before + after; }
  /// Returns the position of the sample point within the bit, in thousandths.
  [[nodiscard]] constexpr std::uint32_t sample_point() const {
    return 1000 * (1 + before) / quanta();
  }
  /// Returns the greatest resynchronisation step in quanta. It is as large as `after` and the
  /// hardware allow, because a larger step tolerates a larger difference between crystals.
  [[nodiscard]] constexpr std::uint32_t jump() const { return after < 4 ? after : 4; }
  [[nodiscard]] constexpr Word word() const {
    return (jump() - 1) << 24 | (after - 1) << 20 | (before - 1) << 16 | (prescaler - 1);
  }
};

/// Wanted position of the sample point, thousandths of a bit (CiA 301, table 1).
inline constexpr std::uint32_t kCanSamplePoint = 875;

/// Returns a timing that has exactly this bit rate and the sample point nearest to kCanSamplePoint.
/// If several are equally near, returns the timing with the most quanta. If no division of the
/// clock gives the rate, returns a timing whose exists() is false.
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

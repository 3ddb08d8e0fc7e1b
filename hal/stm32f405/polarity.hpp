#pragma once

#include <cstdint>

namespace hal::stm32f405 {

/// Which pins are the other way round than the board says; what the settings
/// $2 to $6 and $14 to $16 mean. A bit each, an axis' or in their order.
struct Polarity {
  std::uint8_t steps = 0;
  std::uint8_t directions = 0;
  std::uint8_t enables = 0;
  std::uint8_t limits = 0;
  bool probe = false;
  std::uint8_t controls = 0;  ///< Reset, hold, start, door, emergency stop.
  std::uint8_t coolant = 0;   ///< Flood, mist.
  std::uint8_t spindle = 0;   ///< Enable, direction. Power is never turned round.

  constexpr bool operator==(const Polarity&) const = default;
};

}  // namespace hal::stm32f405

#pragma once

#include <cstdint>

namespace hal::stm32f405 {

/// Pins whose polarity is the opposite of the board's, from the settings $2 to $6 and $14 to $16.
/// Each member has one bit for each axis, or for each pin in the given order.
struct Polarity {
  std::uint8_t steps = 0;
  std::uint8_t directions = 0;
  std::uint8_t enables = 0;
  std::uint8_t limits = 0;
  bool probe = false;
  std::uint8_t controls = 0;  ///< Bits: reset, hold, start, door, emergency stop.
  std::uint8_t coolant = 0;   ///< Bits: flood, mist.
  std::uint8_t spindle = 0;   ///< Bits: enable, direction. The power output is never inverted.

  constexpr bool operator==(const Polarity&) const = default;
};

}  // namespace hal::stm32f405

#pragma once

#include <cstdint>

namespace cnc::motion {

/// Changes of outputs at the start of a motion (M62, M63, M67).
struct OutputChanges {
  static constexpr std::uint8_t kNoAnalog = 0xFF;

  std::uint8_t raise = 0;  ///< Set of the digital outputs that go high; bit i is output i.
  std::uint8_t lower = 0;
  std::uint8_t analog_channel = kNoAnalog;
  std::uint16_t analog_value = 0;  ///< New value of the analog output; 65535 is full scale.

  [[nodiscard]] constexpr bool any() const {
    return raise != 0 || lower != 0 || analog_channel != kNoAnalog;
  }
  constexpr bool operator==(const OutputChanges&) const = default;
};

}  // namespace cnc::motion

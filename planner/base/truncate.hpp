#pragma once

#include <cstdint>

namespace cnc {

/// Returns the whole part of a float. static_cast gives the same result, but the conversion to 64
/// bits that the compiler generates uses double, which a Cortex-M4 emulates.
/// @pre |value| < 2^47.
[[nodiscard]] inline std::int64_t truncated(float value) {
  constexpr float kChunk = 65'536.0F;
  const auto chunks = static_cast<std::int32_t>(value / kChunk);
  // The division and the subtraction are exact.
  const float rest = value - static_cast<float>(chunks) * kChunk;
  return std::int64_t{chunks} * 65'536 + static_cast<std::int32_t>(rest);
}

/// Returns the float nearest to a whole number. Of two equally near floats it returns the even one,
/// as IEEE 754 rounds. static_cast gives the same result, but a Cortex-M4 has no instruction that
/// converts 64 bits. Here a value that fits into 32 bits and a sign takes one instruction instead
/// of a call.
[[nodiscard]] constexpr float nearest_float(std::uint64_t value) {
  const auto low = static_cast<std::uint32_t>(value);
  return value == low ? static_cast<float>(low) : static_cast<float>(value);
}
[[nodiscard]] constexpr float nearest_float(std::int64_t value) {
  return value < 0 ? -nearest_float(static_cast<std::uint64_t>(-value))
                   : nearest_float(static_cast<std::uint64_t>(value));
}

}  // namespace cnc

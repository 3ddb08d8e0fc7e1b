#pragma once

#include <cstdint>

namespace cnc {

/// A number as the unevaluated sum of two floats, the second at most half a
/// unit in the last place of the first: some 48 bits from hardware that has
/// only 24, where a difference of large places must keep its digits. A few
/// dozen operations each, so for places that joints hang on and not for what
/// is evaluated thousands of times.
///
/// Sums and products are those of Dekker (1971) with Knuth's error-free sum
/// and Veltkamp's split; they rely on IEEE 754 and no contraction.
/// Guarantee for +, −, × and ÷: relative error at most kWideError, for sums
/// relative to |a| + |b|. Magnitudes from 1e-20 to 1e30.
struct Wide {
  float high = 0.0F;
  float low = 0.0F;

  constexpr Wide() = default;
  constexpr explicit Wide(float value) : high{value} {}
  constexpr Wide(float high_part, float low_part) : high{high_part}, low{low_part} {}

  [[nodiscard]] constexpr float to_float() const { return high; }
};

inline constexpr double kWideError = 3.0e-14;

/// Exact below 2^48.
[[nodiscard]] Wide to_wide(std::int64_t whole);
/// The nearest whole number. @pre |value| < 2^46
[[nodiscard]] std::int64_t nearest_whole(const Wide& value);

[[nodiscard]] Wide operator+(const Wide& a, const Wide& b);
[[nodiscard]] Wide operator-(const Wide& a, const Wide& b);
[[nodiscard]] Wide operator*(const Wide& a, const Wide& b);
/// @pre b is not zero.
[[nodiscard]] Wide operator/(const Wide& a, const Wide& b);

}  // namespace cnc

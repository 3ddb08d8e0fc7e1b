#pragma once

#include <cstdint>

namespace cnc {

/// A number as the unevaluated sum of two floats. The second float is at most half a unit in the
/// last place of the first. The sum has some 48 bits on hardware whose floats have only 24, so
/// differences of large positions keep their digits. Each operation costs a few dozen float
/// operations. The type is therefore meant for the positions of joints, and not for values that are
/// evaluated thousands of times.
///
/// Sums and products are those of Dekker (1971) with Knuth's error-free sum and Veltkamp's split.
/// They rely on IEEE 754 arithmetic without contraction to fused operations. Guarantee for +, −, ×
/// and ÷: the relative error is at most kWideError, for sums relative to |a| + |b|, with magnitudes
/// from 1e-20 to 1e30.
struct Wide {
  float high = 0.0F;
  float low = 0.0F;

  constexpr Wide() = default;
  constexpr explicit Wide(float value) : high{value} {}
  constexpr Wide(float high_part, float low_part) : high{high_part}, low{low_part} {}

  [[nodiscard]] constexpr float to_float() const { return high; }
};

inline constexpr double kWideError = 3.0e-14;

/// Converts a whole number. The conversion is exact below 2^48.
[[nodiscard]] Wide to_wide(std::int64_t whole);
/// Returns the nearest whole number. @pre |value| < 2^46
[[nodiscard]] std::int64_t nearest_whole(const Wide& value);

[[nodiscard]] Wide operator+(const Wide& a, const Wide& b);
[[nodiscard]] Wide operator-(const Wide& a, const Wide& b);
[[nodiscard]] Wide operator*(const Wide& a, const Wide& b);
/// @pre b is not zero.
[[nodiscard]] Wide operator/(const Wide& a, const Wide& b);

}  // namespace cnc

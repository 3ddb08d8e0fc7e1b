#pragma once

#include <algorithm>

namespace cnc {

/// Our own transcendental functions, in single precision.
///
/// The C libraries of host and controller round sin, cos and atan differently,
/// and what decides motion must give the same bits on both. Only +, −, ×, ÷ and
/// sqrt are used here: IEEE 754 defines those to the last bit. No tables, no
/// loops whose length depends on the value.

inline constexpr float kPi = 3.14159265358979F;
inline constexpr float kTwoPi = 6.28318530717959F;
inline constexpr float kHalfPi = 1.57079632679490F;

[[nodiscard]] constexpr float square(float x) { return x * x; }

template <typename Scalar>
struct BasicSinCos {
  Scalar sine;
  Scalar cosine;
};
using SinCos = BasicSinCos<float>;

/// Sine and cosine of an angle `quarters` quarter turns further; any sign.
[[nodiscard]] SinCos turned_by_quarters(const SinCos& angle, int quarters);

/// Sine and cosine of an angle in radians.
/// Guarantee: absolute error at most kSinCosError for |angle| ≤ kSinCosRange;
/// beyond it the reduction by quarter turns loses digits in proportion.
inline constexpr float kSinCosRange = 1000.0F;
inline constexpr double kSinCosError = 1.3e-7;
[[nodiscard]] SinCos sin_cos(float angle);

/// Tangent of an angle in radians that is within ±π/2.
[[nodiscard]] inline float tangent_of(float angle) {
  const SinCos of = sin_cos(angle);
  return of.sine / of.cosine;
}

/// Arc tangent of t in [0, 1], in radians. Relative error at most kAtanError.
inline constexpr double kAtanError = 2.0e-7;
[[nodiscard]] float atan_unit(float t);

/// Angle of the vector (x, y) in (−π, π]; 0 for the null vector.
/// Absolute error at most kAtan2Error radians.
inline constexpr double kAtan2Error = 3.0e-7;
[[nodiscard]] float atan2_f(float y, float x);

/// Cube root of a number in [1e-30, 1e30]. Relative error at most kCubeRootError.
inline constexpr double kCubeRootError = 2.0e-7;
[[nodiscard]] float cube_root(float value);
/// The same of any positive number: of one that is out of that range, the root of its nearest end.
[[nodiscard]] inline float bounded_cube_root(float value) {
  return cube_root(std::clamp(value, 1.0e-30F, 1.0e30F));
}

/// e^−x for x in [0, 2]. Relative error at most kDecayError.
inline constexpr float kDecayRange = 2.0F;
inline constexpr double kDecayError = 1.0e-6;
[[nodiscard]] float decay(float x);

/// The largest float below `value`; 0 when there is no positive one.
[[nodiscard]] float next_below(float value);

}  // namespace cnc

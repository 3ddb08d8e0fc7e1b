#pragma once

#include <algorithm>

namespace cnc {

/// Kerfline's transcendental functions, in single precision.
///
/// The C libraries of host and controller round sin, cos and atan differently, but results that
/// decide motion must have the same bits on both. Only +, −, ×, ÷ and sqrt are used here, because
/// IEEE 754 defines them to the last bit. There are no tables and no loops whose length depends on
/// the value.

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

/// Returns sine and cosine of an angle after it was increased by `quarters` quarter turns;
/// `quarters` may be negative.
[[nodiscard]] SinCos turned_by_quarters(const SinCos& angle, int quarters);

/// Returns sine and cosine of an angle in radians.
/// Guarantee: the absolute error is at most kSinCosError for |angle| ≤ kSinCosRange. Beyond that
/// range the reduction by quarter turns loses digits in proportion to the angle.
inline constexpr float kSinCosRange = 1000.0F;
inline constexpr double kSinCosError = 1.3e-7;
[[nodiscard]] SinCos sin_cos(float angle);

/// Returns the tangent of an angle in radians. @pre |angle| < π/2
[[nodiscard]] inline float tangent_of(float angle) {
  const SinCos of = sin_cos(angle);
  return of.sine / of.cosine;
}

/// Returns the arc tangent of t in [0, 1], in radians. The relative error is at most kAtanError.
inline constexpr double kAtanError = 2.0e-7;
[[nodiscard]] float atan_unit(float t);

/// Returns the angle of the vector (x, y) in (−π, π], and 0 for the null vector.
/// The absolute error is at most kAtan2Error radians.
inline constexpr double kAtan2Error = 3.0e-7;
[[nodiscard]] float atan2_f(float y, float x);

/// Returns the cube root of a number in [1e-30, 1e30]. The relative error is at most
/// kCubeRootError.
inline constexpr double kCubeRootError = 2.0e-7;
[[nodiscard]] float cube_root(float value);
/// Returns the cube root of a positive number after clamping the number to [1e-30, 1e30].
[[nodiscard]] inline float bounded_cube_root(float value) {
  return cube_root(std::clamp(value, 1.0e-30F, 1.0e30F));
}

/// Returns e^−x for x in [0, 2]. The relative error is at most kDecayError.
inline constexpr float kDecayRange = 2.0F;
inline constexpr double kDecayError = 1.0e-6;
[[nodiscard]] float decay(float x);

/// Returns the largest float below `value`, or 0 if `value` is not positive.
[[nodiscard]] float next_below(float value);

}  // namespace cnc

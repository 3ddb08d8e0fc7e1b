#pragma once

#include "planner/base/scalar_math.hpp"

namespace cnc {

/// Kerfline's transcendental functions in double precision, for path makers on the host. They give
/// the same bits with every C library.

using WideSinCos = BasicSinCos<double>;

/// Returns sine and cosine of an angle in radians. The absolute error is at most kWideSinCosError
/// for |angle| ≤ kWideSinCosRange.
inline constexpr double kWideSinCosRange = 1.0e5;
inline constexpr double kWideSinCosError = 3.0e-16;
[[nodiscard]] WideSinCos sin_cos(double angle);

/// Returns the angle of the vector (x, y) in (−π, π], and 0 for the null vector. The absolute error
/// is at most kWideAtan2Error radians.
inline constexpr double kWideAtan2Error = 1.0e-15;
[[nodiscard]] double wide_atan2(double y, double x);

}  // namespace cnc

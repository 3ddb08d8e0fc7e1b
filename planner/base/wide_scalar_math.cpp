#include "planner/base/wide_scalar_math.hpp"

#include <cmath>
#include <cstdint>

namespace cnc {
namespace {

// Half π in three parts. The first two parts have 33 bits each, so that their product with a
// quarter count below 2^20 is exact.
constexpr double kWideHalfPiHigh = 1.57079632673412561417;
constexpr double kWideHalfPiMiddle = 6.07710050630396597660e-11;
constexpr double kWideHalfPiLow = 2.02226624879595063154e-21;

// Taylor series for |x| up to π/4. The first omitted term is below 2e-17.
double wide_sine_near_zero(double x) {
  const double z = x * x;
  const double high = -1.0 / 39916800.0 + z * (1.0 / 6227020800.0 - z / 1307674368000.0);
  const double low = -1.0 / 6.0 + z * (1.0 / 120.0 + z * (-1.0 / 5040.0 + z / 362880.0));
  return x + x * z * (low + z * z * z * z * high);
}

double wide_cosine_near_zero(double x) {
  const double z = x * x;
  const double high = -1.0 / 3628800.0 + z * (1.0 / 479001600.0 - z / 87178291200.0);
  const double top = high + z * z * z / 20922789888000.0;
  const double low = 1.0 / 24.0 + z * (-1.0 / 720.0 + z / 40320.0);
  return 1.0 - z * (0.5 - z * (low + z * z * z * top));
}

// Taylor series for |x| up to tan(π/16). The first omitted term is below 1e-18 times x.
double atan_near_zero(double x) {
  const double z = x * x;
  double tail = 0.0;
  for (int odd = 23; odd >= 3; odd -= 2) tail = z * (1.0 / static_cast<double>(odd) - tail);
  return x - x * tail;
}

WideSinCos turned_by(const WideSinCos& angle, std::int32_t quarters) {
  const auto [s, c] = angle;
  switch (quarters & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace

WideSinCos sin_cos(double angle) {
  constexpr double kQuartersInOne = 0.63661977236758134308;
  const double quarters = angle * kQuartersInOne;
  const auto count = static_cast<std::int32_t>(quarters + (quarters >= 0.0 ? 0.5 : -0.5));
  const auto turned = static_cast<double>(count);
  const double rest =
      ((angle - turned * kWideHalfPiHigh) - turned * kWideHalfPiMiddle) - turned * kWideHalfPiLow;
  return turned_by({wide_sine_near_zero(rest), wide_cosine_near_zero(rest)}, count);
}

double wide_atan2(double y, double x) {
  constexpr double kQuarterPi = 0.78539816339744830962;
  constexpr double kTanEighthPi = 0.41421356237309504880;
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  const double larger = ax > ay ? ax : ay;
  if (larger <= 0.0) return 0.0;
  const double ratio = (ax > ay ? ay : ax) / larger;
  const bool upper = ratio > kTanEighthPi;
  const double part = upper ? (ratio - 1.0) / (ratio + 1.0) : ratio;
  // Tangent of half of the angle whose tangent is `part`.
  const double half_part = part / (1.0 + std::sqrt(1.0 + part * part));
  const double octant = (upper ? kQuarterPi : 0.0) + 2.0 * atan_near_zero(half_part);
  const double quadrant = ay > ax ? 2.0 * kQuarterPi - octant : octant;
  const double half = x < 0.0 ? 4.0 * kQuarterPi - quadrant : quadrant;
  return y < 0.0 ? -half : half;
}

}  // namespace cnc

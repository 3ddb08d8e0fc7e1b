#include "planner/base/scalar_math.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace cnc {
namespace {

// Half π in three parts, the first two with few enough bits that a product
// with a quarter count below 2^10 is exact (Cody and Waite, 1980).
constexpr float kHalfPiHigh = 1.5703125F;
constexpr float kHalfPiMiddle = 4.83751296997070e-4F;
constexpr float kHalfPiLow = 7.54978995489e-8F;

// Interpolants at Chebyshev nodes for x² up to (π/4)², error below 4e-9.
float sine_near_zero(float x) {
  const float z = x * x;
  return x + x * z * (-0.1666665019F + z * (0.0083320098F + z * -0.0001950056F));
}

float cosine_near_zero(float x) {
  const float z = x * x;
  const float tail = -0.0416666502F + z * (0.0013887563F + z * -2.4460432e-5F);
  return 1.0F - z * (0.5F + z * tail);
}

// The same in double precision: 33 bits of half π in each of the first two parts, so
// that a product with a quarter count below 2^20 is exact.
constexpr double kHalfPiHighD = 1.57079632673412561417;
constexpr double kHalfPiMiddleD = 6.07710050630396597660e-11;
constexpr double kHalfPiLowD = 2.02226624879595063154e-21;

// Taylor series up to π/4, whose first term left out is below 2e-17.
double sine_near_zero(double x) {
  const double z = x * x;
  const double high = -1.0 / 39916800.0 + z * (1.0 / 6227020800.0 - z / 1307674368000.0);
  const double low = -1.0 / 6.0 + z * (1.0 / 120.0 + z * (-1.0 / 5040.0 + z / 362880.0));
  return x + x * z * (low + z * z * z * z * high);
}

double cosine_near_zero(double x) {
  const double z = x * x;
  const double high = -1.0 / 3628800.0 + z * (1.0 / 479001600.0 - z / 87178291200.0);
  const double top = high + z * z * z / 20922789888000.0;
  const double low = 1.0 / 24.0 + z * (-1.0 / 720.0 + z / 40320.0);
  return 1.0 - z * (0.5 - z * (low + z * z * z * top));
}

// Taylor series up to tan(π/16), whose first term left out is below 1e-18 of x.
double atan_near_zero(double x) {
  const double z = x * x;
  double tail = 0.0;
  for (int odd = 23; odd >= 3; odd -= 2) tail = z * (1.0 / static_cast<double>(odd) - tail);
  return x - x * tail;
}

template <typename Scalar>
BasicSinCos<Scalar> quarters_further(const BasicSinCos<Scalar>& angle, int quarters) {
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

SinCos turned_by_quarters(const SinCos& angle, int quarters) {
  return quarters_further(angle, quarters);
}

SinCos sin_cos(float angle) {
  const float quarters = angle * (1.0F / kHalfPi);
  const auto count = static_cast<std::int32_t>(quarters + (quarters >= 0.0F ? 0.5F : -0.5F));
  const auto turned = static_cast<float>(count);
  const float rest =
      ((angle - turned * kHalfPiHigh) - turned * kHalfPiMiddle) - turned * kHalfPiLow;
  return turned_by_quarters({sine_near_zero(rest), cosine_near_zero(rest)}, count);
}

SinCosD sin_cos(double angle) {
  constexpr double kQuartersInOne = 0.63661977236758134308;
  const double quarters = angle * kQuartersInOne;
  const auto count = static_cast<std::int32_t>(quarters + (quarters >= 0.0 ? 0.5 : -0.5));
  const auto turned = static_cast<double>(count);
  const double rest =
      ((angle - turned * kHalfPiHighD) - turned * kHalfPiMiddleD) - turned * kHalfPiLowD;
  return quarters_further<double>({sine_near_zero(rest), cosine_near_zero(rest)}, count);
}

float atan_unit(float t) {
  // Above tan(π/8): atan t = π/4 + atan((t − 1)/(t + 1)).
  constexpr float kTanEighthPi = 0.41421356F;
  constexpr float kQuarterPi = 0.785398163F;
  const bool upper = t > kTanEighthPi;
  const float x = upper ? (t - 1.0F) / (t + 1.0F) : t;
  const float z = x * x;
  const float tail =
      z * (-0.3333330677F +
           z * (0.1999817647F + z * (-0.1423941086F + z * (0.1056892078F + z * -0.0602396318F))));
  const float near_zero = x + x * tail;
  return upper ? kQuarterPi + near_zero : near_zero;
}

float atan2_f(float y, float x) {
  const float ax = std::abs(x);
  const float ay = std::abs(y);
  const float larger = ax > ay ? ax : ay;
  if (larger <= 0.0F) return 0.0F;
  const float ratio = (ax > ay ? ay : ax) / larger;
  const float octant = atan_unit(ratio);
  const float quadrant = ay > ax ? kHalfPi - octant : octant;
  const float half = x < 0.0F ? kPi - quadrant : quadrant;
  return y < 0.0F ? -half : half;
}

double atan2_d(double y, double x) {
  constexpr double kQuarterPi = 0.78539816339744830962;
  constexpr double kTanEighthPi = 0.41421356237309504880;
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  const double larger = ax > ay ? ax : ay;
  if (larger <= 0.0) return 0.0;
  const double ratio = (ax > ay ? ay : ax) / larger;
  const bool upper = ratio > kTanEighthPi;
  const double part = upper ? (ratio - 1.0) / (ratio + 1.0) : ratio;
  // Half the angle's tangent.
  const double half_part = part / (1.0 + std::sqrt(1.0 + part * part));
  const double octant = (upper ? kQuarterPi : 0.0) + 2.0 * atan_near_zero(half_part);
  const double quadrant = ay > ax ? 2.0 * kQuarterPi - octant : octant;
  const double half = x < 0.0 ? 4.0 * kQuarterPi - quadrant : quadrant;
  return y < 0.0 ? -half : half;
}

float cube_root(float value) {
  // A third of the exponent is within 10 %; each step of Halley's triples the digits.
  constexpr std::uint32_t kBias = 0x2A51'4067U;  // (1 - 1/3) of 1's, less what balances the error.
  float root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) / 3U + kBias);
  for (int step = 0; step < 3; ++step) {
    const float cube = root * root * root;
    root *= (cube + 2.0F * value) / (2.0F * cube + value);
  }
  return root;
}

float decay(float x) {
  // The series of an eighth, whose seventh term is below 2^-30, to the eighth power.
  const float z = -0.125F * x;
  const float tail = 1.0F / 24.0F + z * (1.0F / 120.0F + z * (1.0F / 720.0F));
  const float eighth = 1.0F + z * (1.0F + z * (0.5F + z * (1.0F / 6.0F + z * tail)));
  return square(square(square(eighth)));
}

float next_below(float value) {
  if (!(value > 0.0F)) return 0.0F;
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) - 1U);
}

}  // namespace cnc

#include "planner/base/scalar_math.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace cnc {
namespace {

// Half π in three parts (Cody and Waite, 1980). The first two parts have few enough bits that their
// product with a quarter count below 2^10 is exact.
constexpr float kHalfPiHigh = 1.5703125F;
constexpr float kHalfPiMiddle = 4.83751296997070e-4F;
constexpr float kHalfPiLow = 7.54978995489e-8F;

// Interpolants at Chebyshev nodes for x² up to (π/4)². Their error is below 4e-9.
float sine_near_zero(float x) {
  const float z = x * x;
  return x + x * z * (-0.1666665019F + z * (0.0083320098F + z * -0.0001950056F));
}

float cosine_near_zero(float x) {
  const float z = x * x;
  const float tail = -0.0416666502F + z * (0.0013887563F + z * -2.4460432e-5F);
  return 1.0F - z * (0.5F + z * tail);
}

}  // namespace

SinCos turned_by_quarters(const SinCos& angle, int quarters) {
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

SinCos sin_cos(float angle) {
  const float quarters = angle * (1.0F / kHalfPi);
  const auto count = static_cast<std::int32_t>(quarters + (quarters >= 0.0F ? 0.5F : -0.5F));
  const auto turned = static_cast<float>(count);
  const float rest =
      ((angle - turned * kHalfPiHigh) - turned * kHalfPiMiddle) - turned * kHalfPiLow;
  return turned_by_quarters({sine_near_zero(rest), cosine_near_zero(rest)}, count);
}

float atan_unit(float t) {
  // Above tan(π/8) the function uses atan t = π/4 + atan((t − 1)/(t + 1)).
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

float cube_root(float value) {
  // Dividing the exponent by three gives the root within 10 %. Each step of Halley's method triples
  // the number of correct digits.
  constexpr std::uint32_t kBias =
      0x2A51'4067U;  // (1 - 1/3) of the bits of 1.0, minus a term that balances the error.
  float root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) / 3U + kBias);
  for (int step = 0; step < 3; ++step) {
    const float cube = root * root * root;
    root *= (cube + 2.0F * value) / (2.0F * cube + value);
  }
  return root;
}

float decay(float x) {
  // Computes the eighth power of the series of e^(−x/8), whose seventh term is below 2^-30.
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

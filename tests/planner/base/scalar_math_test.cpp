#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "planner/base/wide_scalar_math.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

float from_bits(std::uint32_t bits) { return std::bit_cast<float>(bits); }
std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }

void expect_sin_cos_near(float angle) {
  const SinCos got = sin_cos(angle);
  const auto exact = static_cast<long double>(angle);
  ASSERT_NEAR(
      static_cast<double>(static_cast<long double>(got.sine) - std::sin(exact)), 0.0, kSinCosError)
      << "angle " << angle;
  ASSERT_NEAR(static_cast<double>(static_cast<long double>(got.cosine) - std::cos(exact)),
              0.0,
              kSinCosError)
      << "angle " << angle;
}

TEST(SinCos, KeepsItsBoundForFloatsOfEveryMagnitude) {
  for (std::uint32_t bits = 0; bits <= bits_of(kSinCosRange); bits += 2011) {
    expect_sin_cos_near(from_bits(bits));
    expect_sin_cos_near(-from_bits(bits));
    if (HasFatalFailure()) return;
  }
}

TEST(SinCos, KeepsItsBoundEvenlyOverTheWholeRange) {
  for (int k = -300'000; k <= 300'000; ++k) {
    expect_sin_cos_near(static_cast<float>(k) * (kSinCosRange / 300'000.0F));
    if (HasFatalFailure()) return;
  }
}

// At these angles the quarter is decided, and sine or cosine consists of rounding errors only.
TEST(SinCos, KeepsItsBoundAroundEveryEighthOfATurn) {
  for (int eighth = -1273; eighth <= 1273; ++eighth) {
    const auto near = static_cast<float>(eighth * (std::numbers::pi / 4.0));
    for (int off = -40; off <= 40; ++off) {
      const float angle = from_bits(bits_of(near) + static_cast<std::uint32_t>(off));
      if (!(std::abs(angle) <= kSinCosRange)) continue;
      expect_sin_cos_near(angle);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SinCos, IsExactForNull) {
  EXPECT_EQ(sin_cos(0.0F).sine, 0.0F);
  EXPECT_EQ(sin_cos(0.0F).cosine, 1.0F);
}

TEST(SinCos, MirrorsWithTheAngle) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 10'000; ++trial) {
    const auto angle = static_cast<float>(random.magnitude(1.0e-6, 1000.0));
    ASSERT_EQ(sin_cos(-angle).sine, -sin_cos(angle).sine) << angle;
    ASSERT_EQ(sin_cos(-angle).cosine, sin_cos(angle).cosine) << angle;
  }
}

double atan_error(float t) {
  const long double exact = std::atan(static_cast<long double>(t));
  return static_cast<double>(std::abs(static_cast<long double>(atan_unit(t)) - exact) / exact);
}

TEST(AtanUnit, KeepsItsRelativeBoundDownToTheSmallestNormalFloat) {
  const std::uint32_t smallest = bits_of(std::numeric_limits<float>::min());
  for (std::uint32_t bits = smallest; bits <= bits_of(1.0F); bits += 1009) {
    ASSERT_LE(atan_error(from_bits(bits)), kAtanError) << from_bits(bits);
  }
}

TEST(AtanUnit, KeepsItsRelativeBoundDenselyInItsUpperBinades) {
  for (std::uint32_t bits = bits_of(0.125F); bits <= bits_of(1.0F); bits += 23) {
    ASSERT_LE(atan_error(from_bits(bits)), kAtanError) << from_bits(bits);
  }
}

TEST(AtanUnit, KeepsItsBoundWhereTheFormulaChanges) {
  const std::uint32_t seam = bits_of(0.41421356F);
  for (std::uint32_t bits = seam - 20'000; bits <= seam + 20'000; ++bits) {
    ASSERT_LE(atan_error(from_bits(bits)), kAtanError) << from_bits(bits);
  }
}

// The greatest error of all floats in [0, 1]; a search over every float found its argument.
TEST(AtanUnit, KeepsItsBoundAtItsWorstArgument) {
  EXPECT_LE(atan_error(0x1.bb454ep-2F), kAtanError);
}

TEST(AtanUnit, IsNullForNullAndAnEighthForOne) {
  EXPECT_EQ(atan_unit(0.0F), 0.0F);
  EXPECT_NEAR(static_cast<double>(atan_unit(1.0F)), std::numbers::pi / 4.0, 5.0e-8);
}

void expect_atan2_near(float y, float x) {
  const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
  const auto off = static_cast<double>(static_cast<long double>(atan2_f(y, x)) - exact);
  ASSERT_NEAR(off, 0.0, kAtan2Error) << "y " << y << ", x " << x;
}

TEST(Atan2, KeepsItsBoundForEveryDirectionAndSize) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  for (int trial = 0; trial < 400'000; ++trial) {
    const auto y = static_cast<float>(random.signed_magnitude(1.0e-20, 1.0e20));
    const double ratio =
        random.chance(0.5) ? random.magnitude(0.01, 100.0) : random.magnitude(1.0e-12, 1.0e12);
    const auto x =
        static_cast<float>(static_cast<double>(y) * (random.chance(0.5) ? ratio : -ratio));
    expect_atan2_near(y, x);
    if (HasFatalFailure()) return;
  }
}

TEST(Atan2, KeepsItsBoundAllAroundTheCircle) {
  for (int k = 0; k < 200'000; ++k) {
    const double angle = k * (2.0 * std::numbers::pi / 200'000.0);
    expect_atan2_near(static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)));
    if (HasFatalFailure()) return;
  }
}

TEST(Atan2, KnowsTheAxesAndTheNullVector) {
  EXPECT_EQ(atan2_f(0.0F, 0.0F), 0.0F);
  EXPECT_EQ(atan2_f(0.0F, 3.0F), 0.0F);
  EXPECT_EQ(atan2_f(3.0F, 0.0F), kHalfPi);
  EXPECT_EQ(atan2_f(-3.0F, 0.0F), -kHalfPi);
  EXPECT_EQ(atan2_f(0.0F, -3.0F), kPi);
  EXPECT_EQ(atan2_f(-0.0F, -3.0F), kPi);
}

TEST(Atan2, TakesTheSmallestAndTheGreatestFloats) {
  const float small = std::numeric_limits<float>::denorm_min();
  const float great = std::numeric_limits<float>::max();
  for (const float y : {small, -small, great, -great}) {
    for (const float x : {small, -small, great, -great}) expect_atan2_near(y, x);
  }
}

TEST(NextBelow, IsTheNeighbourOfEveryPositiveFloat) {
  for (std::uint32_t bits = 1; bits < bits_of(std::numeric_limits<float>::max()); bits += 65'537) {
    const float value = from_bits(bits);
    ASSERT_EQ(next_below(value), std::nextafter(value, 0.0F)) << value;
  }
}

TEST(NextBelow, IsNullWhereThereIsNone) {
  EXPECT_EQ(next_below(0.0F), 0.0F);
  EXPECT_EQ(next_below(-1.0F), 0.0F);
  EXPECT_EQ(next_below(std::numeric_limits<float>::quiet_NaN()), 0.0F);
}

TEST(Decay, KeepsItsBoundOverItsRange) {
  for (int i = 0; i <= 200'000; ++i) {
    const float x = static_cast<float>(i) * (kDecayRange / 200'000.0F);
    const double exact = std::exp(-static_cast<double>(x));
    ASSERT_NEAR(static_cast<double>(decay(x)) / exact, 1.0, kDecayError) << x;
  }
  EXPECT_EQ(decay(0.0F), 1.0F);
}

void expect_sin_cos_near_d(double angle) {
  const WideSinCos got = sin_cos(angle);
  const auto exact = static_cast<long double>(angle);
  const long double sine = std::abs(static_cast<long double>(got.sine) - std::sin(exact));
  const long double cosine = std::abs(static_cast<long double>(got.cosine) - std::cos(exact));
  ASSERT_LE(static_cast<double>(sine), kWideSinCosError) << "angle " << angle;
  ASSERT_LE(static_cast<double>(cosine), kWideSinCosError) << "angle " << angle;
}

TEST(SinCosInDouble, KeepsItsBoundForEveryMagnitude) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 400'000; ++trial) {
    expect_sin_cos_near_d(random.signed_magnitude(1.0e-18, kWideSinCosRange));
    expect_sin_cos_near_d(random.between(-4.0, 4.0));
    if (HasFatalFailure()) return;
  }
}

// At these angles the quarter is decided, and sine or cosine consists of rounding errors only.
TEST(SinCosInDouble, KeepsItsBoundAroundEveryEighthOfATurn) {
  for (int eighth = -127'000; eighth <= 127'000; eighth += 7) {
    double angle = eighth * (std::numbers::pi / 4.0);
    if (std::abs(angle) > kWideSinCosRange - 1.0) continue;
    angle = std::nextafter(angle, -1.0e9);
    for (int off = 0; off < 3; ++off, angle = std::nextafter(angle, 1.0e9)) {
      expect_sin_cos_near_d(angle);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Atan2InDouble, KeepsItsBoundForVectorsOfEveryDirectionAndSize) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 400'000; ++trial) {
    const double y = random.signed_magnitude(1.0e-12, 1.0e6);
    const double x = random.chance(0.5) ? random.signed_magnitude(1.0e-12, 1.0e6)
                                        : y * random.between(-3.0, 3.0);
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    const long double error = std::abs(static_cast<long double>(wide_atan2(y, x)) - exact);
    ASSERT_LE(static_cast<double>(error), kWideAtan2Error) << y << ' ' << x;
  }
}

TEST(Atan2InDouble, IsExactAlongTheAxes) {
  EXPECT_EQ(wide_atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(wide_atan2(0.0, 3.0), 0.0);
  EXPECT_EQ(wide_atan2(2.0, 0.0), std::numbers::pi / 2.0);
  EXPECT_EQ(wide_atan2(-2.0, 0.0), -std::numbers::pi / 2.0);
  EXPECT_EQ(wide_atan2(0.0, -1.0), std::numbers::pi);
}

}  // namespace
}  // namespace cnc

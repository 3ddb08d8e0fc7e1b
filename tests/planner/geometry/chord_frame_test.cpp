#include "planner/geometry/chord_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "planner/base/scalar_math.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

constexpr long double kOneQ30 = 1073741824.0L;
constexpr std::uint32_t kAlmostWhole = 0xFFFF'FFFFU;

struct ExactPoint {
  long double along;
  long double across;
  long double along_rate;
  long double across_rate;
};

/// Computes the point by the definition, with the difference of cosines as a product, so that no
/// digits cancel.
ExactPoint exact_at(float half_sweep, std::uint32_t fraction) {
  const long double mu = static_cast<long double>(fraction) / 2147483648.0L - 1.0L;
  const auto h = static_cast<long double>(half_sweep);
  if (half_sweep == 0.0F) return {0.5L + 0.5L * mu, 0.0L, 1.0L, 0.0L};
  const long double sine = std::sin(h);
  return {0.5L + 0.5L * std::sin(mu * h) / sine,
          -std::sin(0.5L * (1.0L + mu) * h) * std::sin(0.5L * (1.0L - mu) * h) / sine,
          h * std::cos(mu * h) / sine,
          h * std::sin(mu * h) / sine};
}

void expect_exact(float half_sweep, std::uint32_t fraction) {
  const ChordPoint got = ChordFrame{half_sweep}.at(fraction);
  const ExactPoint exact = exact_at(half_sweep, fraction);
  const auto along = static_cast<double>(got.along_q30 / kOneQ30 - exact.along);
  const auto across = static_cast<double>(got.across_q30 / kOneQ30 - exact.across);
  ASSERT_NEAR(along, 0.0, ChordFrame::kChordPointError) << half_sweep << " at " << fraction;
  ASSERT_NEAR(across, 0.0, ChordFrame::kChordPointError) << half_sweep << " at " << fraction;
}

class ChordFrameTest : public testing::Test {
 protected:
  float any_half_sweep() {
    return static_cast<float>(random.signed_magnitude(1.0e-7, std::numbers::pi / 2.0));
  }
  std::uint32_t any_fraction() { return static_cast<std::uint32_t>(random.bits()); }

  proof::Random random{proof::test_seed()};
};

TEST_F(ChordFrameTest, KeepsItsBoundForEveryArcAndFraction) {
  for (int trial = 0; trial < 400'000; ++trial) {
    expect_exact(any_half_sweep(), any_fraction());
    if (HasFatalFailure()) return;
  }
}

TEST_F(ChordFrameTest, KeepsItsBoundEvenlyOverSweepAndFraction) {
  for (int sweep = -400; sweep <= 400; ++sweep) {
    const float half_sweep = kHalfPi * (static_cast<float>(sweep) / 400.0F);
    for (std::uint32_t part = 0; part < 512; ++part) expect_exact(half_sweep, part << 23);
    expect_exact(half_sweep, kAlmostWhole);
    if (HasFatalFailure()) return;
  }
}

TEST_F(ChordFrameTest, KeepsItsBoundNearBothEnds) {
  for (int trial = 0; trial < 100'000; ++trial) {
    const float half_sweep = any_half_sweep();
    const auto near = static_cast<std::uint32_t>(random.magnitude(1.0, 1.0e6));
    expect_exact(half_sweep, near);
    expect_exact(half_sweep, kAlmostWhole - near);
    if (HasFatalFailure()) return;
  }
}

// The bulge has its greatest value: see Arc::kLargestBulge.
TEST_F(ChordFrameTest, KeepsItsBoundForAHalfTurnThatWasRounded) {
  for (const float half_sweep : {kHalfPi + 1.0e-5F, -kHalfPi - 1.0e-5F, kHalfPi, -kHalfPi}) {
    for (std::uint32_t part = 0; part < 4096; ++part) expect_exact(half_sweep, part << 20);
    if (HasFatalFailure()) return;
  }
}

TEST_F(ChordFrameTest, KeepsItsBoundForAnyArcThatIsAlmostALine) {
  for (double size = 1.0e-38; size < 1.0e-4; size *= 7.3) {
    for (std::uint32_t part = 0; part < 64; ++part) {
      expect_exact(static_cast<float>(size), part << 26);
      expect_exact(static_cast<float>(-size), part << 26);
    }
    if (HasFatalFailure()) return;
  }
}

TEST_F(ChordFrameTest, IsExactForALine) {
  const ChordFrame line;
  for (int trial = 0; trial < 10'000; ++trial) {
    const std::uint32_t fraction = any_fraction();
    ASSERT_NEAR(line.at(fraction).along_q30, static_cast<double>(fraction) / 4.0, 1.0);
    ASSERT_EQ(line.at(fraction).across_q30, 0);
  }
}

TEST_F(ChordFrameTest, RatesAreTheDerivatives) {
  for (int trial = 0; trial < 200'000; ++trial) {
    const float half_sweep = any_half_sweep();
    const std::uint32_t fraction = any_fraction();
    const ChordPoint got = ChordFrame{half_sweep}.at(fraction);
    const ExactPoint exact = exact_at(half_sweep, fraction);
    ASSERT_NEAR(static_cast<double>(got.along_rate), static_cast<double>(exact.along_rate), 1.0e-6)
        << half_sweep << " at " << fraction;
    ASSERT_NEAR(
        static_cast<double>(got.across_rate), static_cast<double>(exact.across_rate), 1.0e-6)
        << half_sweep << " at " << fraction;
  }
}

TEST_F(ChordFrameTest, NeverTurnsBackAlongTheChord) {
  for (int trial = 0; trial < 200; ++trial) {
    const ChordFrame frame{any_half_sweep()};
    std::int32_t before = frame.at(0).along_q30;
    for (std::uint32_t part = 1; part < 4096; ++part) {
      const std::int32_t along = frame.at(part << 20).along_q30;
      ASSERT_GT(along, before) << "part " << part;
      before = along;
    }
  }
}

TEST_F(ChordFrameTest, MirrorsWithTheSweep) {
  for (int trial = 0; trial < 20'000; ++trial) {
    const float half_sweep = any_half_sweep();
    const std::uint32_t fraction = any_fraction();
    const ChordPoint left = ChordFrame{half_sweep}.at(fraction);
    const ChordPoint right = ChordFrame{-half_sweep}.at(fraction);
    ASSERT_EQ(left.along_q30, right.along_q30);
    ASSERT_NEAR(left.across_q30, -right.across_q30, 1);
  }
}

// An arc that turns left lies to the right of its chord.
TEST_F(ChordFrameTest, LiesOnTheOuterSide) {
  EXPECT_LT(ChordFrame{1.0F}.at(1U << 31).across_q30, 0);
  EXPECT_GT(ChordFrame{-1.0F}.at(1U << 31).across_q30, 0);
}

}  // namespace
}  // namespace cnc

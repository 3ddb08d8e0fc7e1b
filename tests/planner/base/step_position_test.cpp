#include "planner/base/step_position.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

using namespace literals;
__extension__ using Int128 = __int128;

constexpr std::int64_t kFarthest = Coordinate::kFarthestNanometres;
constexpr std::int64_t kOneStep = std::int64_t{1} << 32;

// A half rounds up, on either side of zero.
static_assert(StepPosition{}.nearest_step() == 0);
static_assert(StepPosition{kOneStep / 2 - 1}.nearest_step() == 0);
static_assert(StepPosition{kOneStep / 2}.nearest_step() == 1);
static_assert(StepPosition{-kOneStep / 2 + 1}.nearest_step() == 0);
static_assert(StepPosition{-kOneStep / 2}.nearest_step() == -1);
static_assert(StepPosition::whole(-5).q32() == -5 * kOneStep);
static_assert(StepPosition::whole(1 << 30).nearest_step() == 1 << 30);
static_assert(StepPosition::whole(-(1 << 30)).nearest_step() == -(1 << 30));

TEST(StepPosition, NearestStepIsNeverMoreThanHalfAStepAway) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 100'000; ++trial) {
    const auto q32 = static_cast<std::int64_t>(random.signed_magnitude(1.0, 4.6e18));
    const std::int64_t off = q32 - StepPosition::whole(StepPosition{q32}.nearest_step()).q32();
    ASSERT_LE(off, kOneStep / 2 - 1) << q32;
    ASSERT_GE(off, -kOneStep / 2) << q32;
  }
}

/// Returns steps_per_mm · 2^40, which is an integer for every float ≥ 2^-16.
Int128 fixed_resolution(float steps_per_mm) {
  return static_cast<Int128>(std::ldexp(static_cast<long double>(steps_per_mm), 40));
}

/// Returns 2^32 · nm · steps_per_mm / 10^6, truncated towards zero.
Int128 exact_q32(std::int64_t nm, float steps_per_mm) {
  return Int128{nm} * fixed_resolution(steps_per_mm) / (Int128{1'000'000} << 8);
}

class AxisScaleOfRandomResolution : public testing::Test {
 protected:
  float any_resolution() {
    const double any = random.magnitude(0.01, 100'000.0);
    return std::clamp(
        static_cast<float>(any), AxisScale::kMinStepsPerMm, AxisScale::kMaxStepsPerMm);
  }
  std::int64_t any_place() {
    return static_cast<std::int64_t>(
        std::llround(random.signed_magnitude(1.0, static_cast<double>(kFarthest))));
  }

  proof::Random random{proof::test_seed()};
};

TEST_F(AxisScaleOfRandomResolution, IsExactToTheLastBit) {
  int within = 0;
  for (int trial = 0; trial < 200'000; ++trial) {
    const AxisScale scale{any_resolution()};
    const std::int64_t nm = any_place();
    const Int128 exact = exact_q32(nm, scale.steps_per_mm());
    const auto steps = scale.steps_at(Coordinate{nm});
    if (!steps) {
      const Int128 size = exact < 0 ? -exact : exact;
      ASSERT_GE(size >> 32, Int128{AxisScale::kMaxSteps}) << nm << " at " << scale.steps_per_mm();
      continue;
    }
    ++within;
    ASSERT_LE(steps->q32() - exact, Int128{1}) << nm << " at " << scale.steps_per_mm();
    ASSERT_GE(steps->q32() - exact, Int128{-1}) << nm << " at " << scale.steps_per_mm();
  }
  EXPECT_GT(within, 50'000);
}

TEST_F(AxisScaleOfRandomResolution, MirrorsWithThePlace) {
  for (int trial = 0; trial < 20'000; ++trial) {
    const AxisScale scale{any_resolution()};
    const Coordinate place{any_place()};
    const auto there = scale.steps_at(place);
    const auto opposite = scale.steps_at(-place);
    ASSERT_EQ(there.has_value(), opposite.has_value());
    if (!there) continue;
    ASSERT_EQ(there->q32(), -opposite->q32());
  }
}

TEST_F(AxisScaleOfRandomResolution, FindsItsWayBackToTheStep) {
  for (int trial = 0; trial < 200'000; ++trial) {
    const AxisScale scale{any_resolution()};
    const auto step = static_cast<std::int32_t>(random.signed_magnitude(1.0, 1.07e9));
    const Coordinate place = scale.place_of(step);
    if (!place.in_range()) continue;
    const auto steps = scale.steps_at(place);
    ASSERT_TRUE(steps.has_value()) << step << " at " << scale.steps_per_mm();
    ASSERT_EQ(steps->nearest_step(), step) << " at " << scale.steps_per_mm();
  }
}

// The condition |position · steps_per_mm − step| ≤ half a nanometre, in integers.
TEST_F(AxisScaleOfRandomResolution, PutsAStepAtTheNearestNanometre) {
  for (int trial = 0; trial < 200'000; ++trial) {
    const AxisScale scale{any_resolution()};
    const auto step = static_cast<std::int32_t>(random.signed_magnitude(1.0, 2.1e9));
    const Int128 resolution = fixed_resolution(scale.steps_per_mm());
    const Int128 product = Int128{scale.place_of(step).nanometres()} * resolution;
    const Int128 off = product - (Int128{step} * 1'000'000 << 40);
    ASSERT_LE(2 * (off < 0 ? -off : off), resolution) << step << " at " << scale.steps_per_mm();
  }
}

TEST_F(AxisScaleOfRandomResolution, KeepsTheOrderOfPlaces) {
  for (int trial = 0; trial < 50'000; ++trial) {
    const AxisScale scale{any_resolution()};
    const Coordinate place{any_place()};
    const auto here = scale.steps_at(place);
    const auto next = scale.steps_at(place + 1_nm);
    if (!here || !next) continue;
    ASSERT_LE(here->q32(), next->q32()) << place.nanometres();
  }
}

TEST(AxisScale, IsEmptyExactlyFromItsMostStepsOn) {
  const AxisScale scale{2000.0F};  // A step is 500 nm.
  const Coordinate first_beyond{AxisScale::kMaxSteps * 500};
  EXPECT_FALSE(scale.steps_at(first_beyond).has_value());
  EXPECT_FALSE(scale.steps_at(-first_beyond).has_value());
  EXPECT_TRUE(scale.steps_at(first_beyond - 1_nm).has_value());
  const auto last = scale.steps_at(first_beyond - 500_nm);
  ASSERT_TRUE(last.has_value());
  EXPECT_EQ(last->nearest_step(), AxisScale::kMaxSteps - 1);
}

TEST(AxisScale, IsEmptyForEveryPlaceOutOfRange) {
  const AxisScale coarse{0.01F};
  EXPECT_TRUE(coarse.steps_at(Coordinate{kFarthest}).has_value());
  EXPECT_FALSE(coarse.steps_at(Coordinate{kFarthest + 1}).has_value());
  EXPECT_FALSE(coarse.steps_at(Coordinate{-kFarthest - 1}).has_value());
  EXPECT_FALSE(coarse.steps_at(Coordinate{INT64_MAX}).has_value());
  EXPECT_FALSE(coarse.steps_at(Coordinate{INT64_MIN}).has_value());
}

TEST(AxisScale, TakesItsExtremeResolutions) {
  EXPECT_EQ(AxisScale{0.01F}.steps_at(100'000'000_nm)->nearest_step(), 1);
  EXPECT_EQ(AxisScale{100'000.0F}.steps_at(1'000'000_nm)->nearest_step(), 100'000);
  EXPECT_EQ(AxisScale{100'000.0F}.place_of(1), 10_nm);
}

TEST(AxisScaleDeathTest, RefusesResolutionsOutOfRange) {
  EXPECT_DEATH(AxisScale{0.0099F}, "contract failed");
  EXPECT_DEATH(AxisScale{100'001.0F}, "contract failed");
}

}  // namespace
}  // namespace cnc

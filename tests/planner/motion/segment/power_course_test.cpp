#include "planner/motion/segment/power_course.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

constexpr double kFull = 65'535.0;

double level(const PowerCourse& course, std::uint32_t stair) {
  return course.first + static_cast<double>(course.growth_q8) * stair / 256.0;
}

TEST(PowerCourse, IsConstantWhereTheDutyIs) {
  EXPECT_EQ(power_course(0.5F, 0.5F, 4000), (PowerCourse{.first = 32'768, .interval = 400}));
  EXPECT_TRUE(power_course(0.0F, 0.0F, 4000).dark());
}

TEST(PowerCourse, OfATickIsItsMean) {
  for (const std::uint32_t ticks : {0U, 1U, 400U}) {
    const PowerCourse course = power_course(0.0F, 1.0F, ticks);
    EXPECT_EQ(course.first, 32'768) << ticks;
    EXPECT_EQ(course.growth_q8, 0);
  }
}

/// For any slope over any slice, each stair lasts at most 100 µs and passes through the middle of
/// the slope. No stair is outside of the two ends.
TEST(PowerCourse, FollowsAnySlope) {
  std::mt19937 random{proof::test_seed()};
  std::uniform_real_distribution<float> duty{0.0F, 1.0F};
  for (int trial = 0; trial < 20'000; ++trial) {
    const float from = trial % 3 == 0 ? 0.0F : duty(random);
    const float to = trial % 3 == 1 ? 0.0F : trial % 7 == 0 ? 1.0F : duty(random);
    const auto ticks = static_cast<std::uint32_t>(1 + random() % 24'000);
    const PowerCourse course = power_course(from, to, ticks);
    ASSERT_LE(course.interval, 400);
    const std::uint32_t stairs = course.growth_q8 == 0 ? 1 : (ticks - 1) / course.interval + 1;
    for (std::uint32_t stair = 0; stair < stairs; ++stair) {
      const double value = level(course, stair);
      // The step interrupt outputs the integer part of the value.
      ASSERT_LT(value, kFull + 1.0) << from << " " << to << " " << ticks;
      ASSERT_GE(value, -1.0);
      if (course.growth_q8 == 0) continue;
      const double middle = (stair + 0.5) * course.interval / ticks;
      const double slope = kFull * (from + (to - from) * std::min(1.0, middle));
      // Stairs are rounded up, so each is at most a tick too long.
      const double tolerance = 1.0 + kFull * std::abs(to - from) * stairs / ticks;
      ASSERT_NEAR(value, slope, tolerance) << from << " " << to << " " << ticks;
    }
  }
}

}  // namespace
}  // namespace cnc::motion

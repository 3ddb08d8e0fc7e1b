#include "planner/order/rapid_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/random_source.hpp"
#include "tests/support/straight_move.hpp"
#include "tests/support/trials.hpp"

namespace {

using cnc::order::move_time;
using cnc::order::RapidLimits;
using cnc::order::RapidTime;

double power_of_ten(proof::Random& random, double least, double most) {
  return std::pow(10.0, random.between(least, most));
}

/// The oracle computes the seven phases; the time must be their sum.
TEST(RapidTimeTest, IsThatOfTheSevenPhases) {
  for (const std::uint64_t seed : proof::Trials{20'000}) {
    proof::Random random{seed};
    const double length = power_of_ten(random, -3.0, 4.0);
    const double rate = power_of_ten(random, 0.0, 3.0);
    const double acceleration = power_of_ten(random, 1.0, 4.5);
    const bool has_jerk = random.chance(0.7);
    const double jerk = has_jerk ? power_of_ten(random, 2.0, 6.5) : 0.0;
    const double infinite = std::numeric_limits<double>::infinity();
    const double seconds =
        sim::straight_move(length, rate, acceleration, has_jerk ? jerk : infinite).seconds();
    ASSERT_NEAR(move_time(length, rate, acceleration, jerk), seconds, 1.0e-9 * seconds)
        << "KERFLINE_SEED=" << seed;
  }
}

/// Each axis alone keeps its limits, so the time must be that of the slowest axis alone.
TEST(RapidTimeTest, IsTheTimeOfTheAxisThatTakesLongest) {
  for (const std::uint64_t seed : proof::Trials{5'000}) {
    proof::Random random{seed};
    RapidLimits limits;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      limits.rate_mm_s[axis] = power_of_ten(random, 0.5, 3.0);
      limits.acceleration_mm_s2[axis] = power_of_ten(random, 1.5, 4.5);
    }
    const double x = random.between(-500.0, 500.0);
    const double y = random.between(-500.0, 500.0);
    const double time = RapidTime{limits}(x, y);
    const auto alone = [&](double length, std::size_t axis) {
      return move_time(
          std::abs(length), limits.rate_mm_s[axis], limits.acceleration_mm_s2[axis], 0.0);
    };
    EXPECT_GE(time, std::max(alone(x, 0), alone(y, 1)) * (1.0 - 1.0e-12));
    EXPECT_NEAR(RapidTime{limits}(x, 0.0), alone(x, 0), 1.0e-9);
    EXPECT_NEAR(RapidTime{limits}(0.0, y), alone(y, 1), 1.0e-9);
    EXPECT_EQ(time, RapidTime{limits}(-x, y));
    if (HasFailure()) return;
  }
  EXPECT_EQ(RapidTime{RapidLimits{}}(0.0, 0.0), 0.0);
}

}  // namespace

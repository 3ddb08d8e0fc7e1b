#include "planner/order/rapid_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::order {
namespace {

struct MoveLimits {
  double rate = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
};

/// Returns the time of a move from rest to rest by adding short steps. The acceleration increases
/// by the jerk, remains constant, and decreases, as the remaining change of speed allows. The
/// second half mirrors the first.
double stepped_time(double length, const MoveLimits& limits) {
  // Length of a step, s. If full acceleration begins or ends a step too late or too early, the end
  // of the acceleration moves by up to sqrt(2 A kStep / J): 0.05 ms at A = 2,300 mm/s2 and
  // J = 190,000 mm/s3.
  constexpr double kStep = 1.0e-7;
  const auto half_way = [&](double top, double& seconds) {
    double speed = 0.0;
    double acceleration = 0.0;
    double way = 0.0;
    seconds = 0.0;
    while (speed < top && way < length) {
      const double to_zero = 0.5 * acceleration * acceleration / limits.jerk;
      const double change = top - speed > to_zero ? limits.jerk : -limits.jerk;
      acceleration =
          std::clamp(acceleration + change * kStep, limits.jerk * kStep, limits.acceleration);
      speed += acceleration * kStep;
      way += speed * kStep;
      seconds += kStep;
    }
    return way;
  };
  double low = 0.0;
  double high = limits.rate;
  double seconds = 0.0;
  if (half_way(high, seconds) > 0.5 * length) {
    for (int i = 0; i < 24; ++i) {
      const double middle = 0.5 * (low + high);
      (half_way(middle, seconds) > 0.5 * length ? high : low) = middle;
    }
    static_cast<void>(half_way(low, seconds));
    return 2.0 * seconds;
  }
  const double ramp = half_way(high, seconds);
  return 2.0 * seconds + (length - 2.0 * ramp) / high;
}

TEST(RapidTime, OfAMoveIsThatOfSmallSteps) {
  for (const std::uint64_t seed : proof::Trials{30}) {
    proof::Random random{seed};
    const MoveLimits limits{random.magnitude(20.0, 300.0),
                            random.magnitude(500.0, 5'000.0),
                            random.magnitude(2.0e4, 2.0e6)};
    const double length = random.magnitude(0.5, 60.0);
    const double exact = stepped_time(length, limits);
    EXPECT_NEAR(move_time(length, limits.rate, limits.acceleration, limits.jerk),
                exact,
                0.004 * exact + 1.0e-4)
        << length << " mm, " << limits.rate << ' ' << limits.acceleration << ' ' << limits.jerk;
  }
}

TEST(RapidTime, GrowsWithTheLengthAndIsNeverBelowThatOfFullSpeed) {
  for (const std::uint64_t seed : proof::Trials{2000}) {
    proof::Random random{seed};
    const double rate = random.magnitude(5.0, 300.0);
    const double acceleration = random.magnitude(50.0, 5'000.0);
    const double jerk = random.chance(0.5) ? 0.0 : random.magnitude(1.0e3, 1.0e6);
    const double length = random.magnitude(1.0e-3, 1.0e3);
    const double seconds = move_time(length, rate, acceleration, jerk);
    EXPECT_LT(seconds, move_time(1.1 * length, rate, acceleration, jerk));
    EXPECT_GE(seconds, move_time(length, rate, acceleration, 0.0) * (1.0 - 1.0e-9));
    EXPECT_GE(seconds, length / rate * (1.0 - 1.0e-9));
  }
}

TEST(RapidTime, OfADiagonalHasTheLimitsOfBothAxes) {
  const RapidTime time{{{100.0, 50.0}, {1000.0, 250.0}, {0.0, 0.0}}};
  EXPECT_NEAR(time(300.0, 300.0), 300.0 / 50.0 + 50.0 / 250.0, 1.0e-9);
  EXPECT_NEAR(time(-300.0, 0.0), 3.0 + 0.1, 1.0e-9);
  EXPECT_EQ(time(0.0, 0.0), 0.0);
}

}  // namespace
}  // namespace cnc::order

#include "tests/support/straight_move.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Result of driving the seven phases one after the other.
struct DrivenMove {
  double length = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
  double peak_acceleration = 0.0;

  void drive(double seconds, double jerk) {
    length += ((jerk * seconds / 6.0 + acceleration / 2.0) * seconds + speed) * seconds;
    speed += (jerk * seconds / 2.0 + acceleration) * seconds;
    acceleration += jerk * seconds;
    peak_acceleration = std::max(peak_acceleration, acceleration);
  }
};

DrivenMove drive_phases(const StraightMove& move, double jerk) {
  DrivenMove driven;
  const std::array times{move.jerk_time,
                         move.level_time,
                         move.jerk_time,
                         move.cruise_time,
                         move.jerk_time,
                         move.level_time,
                         move.jerk_time};
  const std::array signs{1.0, 0.0, -1.0, 0.0, -1.0, 0.0, 1.0};
  for (std::size_t i = 0; i < times.size(); ++i) driven.drive(times[i], signs[i] * jerk);
  return driven;
}

TEST(StraightMove, AllSevenPhases) {
  // 0.01 s to 1000 mm/s² and 0.1 s to 100 mm/s make a ramp of 0.11 s.
  const StraightMove move = straight_move(100.0, 100.0, 1000.0, 1.0e5);
  EXPECT_NEAR(move.seconds(), 1.0 + 0.11, 1e-12);
  EXPECT_NEAR(move.jerk_time, 0.01, 1e-15);
  EXPECT_NEAR(move.level_time, 0.09, 1e-15);
}

TEST(StraightMove, TooShortForFullSpeed) {
  // v²/A + v A/J = 5.5 at v = 50 for A = 500, J = 50000.
  const StraightMove move = straight_move(5.5, 100.0, 500.0, 5.0e4);
  EXPECT_NEAR(move.peak_speed, 50.0, 1e-12);
  EXPECT_NEAR(move.seconds(), 2.0 * (0.1 + 0.01), 1e-12);
}

TEST(StraightMove, TooShortForFullAcceleration) {
  const StraightMove move = straight_move(1.0e-3, 100.0, 500.0, 5.0e4);
  EXPECT_NEAR(move.seconds(), std::cbrt(32.0 * 1.0e-3 / 5.0e4), 1e-12);
  EXPECT_EQ(move.level_time, 0.0);
}

TEST(StraightMove, FullSpeedWithoutFullAcceleration) {
  const StraightMove move = straight_move(100.0, 2.0, 500.0, 5.0e4);
  EXPECT_NEAR(move.seconds(), 50.0 + 2.0 * std::sqrt(2.0 / 5.0e4), 1e-12);
}

TEST(StraightMove, UnlimitedJerkIsATrapezoid) {
  EXPECT_NEAR(straight_move(100.0, 100.0, 1000.0, kUnlimited).seconds(), 1.1, 1e-12);
  EXPECT_NEAR(
      straight_move(1.0, kUnlimited, 1000.0, kUnlimited).seconds(), 2.0 * std::sqrt(1.0e-3), 1e-12);
}

TEST(StraightMove, PhasesDriveTheLengthWithinEveryLimit) {
  for (const std::uint64_t seed : proof::Trials{10'000}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const double length = random.magnitude(1.0e-4, 1.0e3);
    const double speed = random.magnitude(0.1, 1.0e3);
    const double acceleration = random.magnitude(10.0, 1.0e4);
    const double jerk = random.magnitude(1.0e3, 1.0e7);
    const StraightMove move = straight_move(length, speed, acceleration, jerk);
    const DrivenMove driven = drive_phases(move, jerk);
    ASSERT_NEAR(driven.length / length, 1.0, 1e-9);
    ASSERT_NEAR(driven.speed, 0.0, 1e-9 * speed);
    ASSERT_LE(driven.peak_acceleration, acceleration * (1.0 + 1e-12));
    ASSERT_LE(move.peak_speed, speed);
    ASSERT_GE(move.cruise_time, 0.0);
    // A time-optimal move reaches the limit of speed, or else that of acceleration or jerk.
    const bool fast = move.peak_speed == speed;
    const bool strong = driven.peak_acceleration >= acceleration * (1.0 - 1e-9);
    ASSERT_TRUE(fast || strong || move.level_time == 0.0);
    ASSERT_TRUE(fast || move.cruise_time == 0.0);
  }
}

}  // namespace
}  // namespace sim

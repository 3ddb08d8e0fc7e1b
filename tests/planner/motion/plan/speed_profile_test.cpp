#include "planner/motion/plan/speed_profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

/// Result of driving a block to its end, or to standstill.
struct Ride {
  double time = 0.0;
  double distance = 0.0;
  double top_speed = 0.0;
  int phases = 0;
};

class SpeedProfileTest : public testing::Test {
 protected:
  void begin(const Block& of, float exit_square = 0.0F, float entry_square = 0.0F) {
    block = of;
    const BrakingState exit{.speed_square = exit_square, .commit_square = exit_square};
    profile.begin(block, limits, {.overrides = overrides}, exit, entry_square);
  }

  Ride drive(Drive drive = Drive::kOn) {
    Ride ride;
    while (!profile.at_end() && ride.phases < 10'000) {
      const Phase phase = profile.next_phase(drive);
      if (phase.duration <= 0.0F) break;
      ride.time += static_cast<double>(phase.duration);
      ride.distance += static_cast<double>(phase.distance);
      ride.top_speed = std::max({ride.top_speed,
                                 static_cast<double>(phase.start_speed),
                                 std::sqrt(static_cast<double>(phase.end_speed_square))});
      ++ride.phases;
      profile.complete(phase);
    }
    return ride;
  }

  /// Drives the first `seconds`, in one piece for each phase.
  void drive_for(float seconds) {
    for (int phases = 0; seconds > 0.0F && phases < 100; ++phases) {
      const Phase phase = profile.next_phase(Drive::kOn);
      if (phase.duration <= seconds) {
        profile.complete(phase);
      } else {
        stop_within(phase, seconds);
      }
      seconds -= phase.duration;
    }
  }

  void stop_within(const Phase& phase, float seconds) {
    const float speed = phase.start_speed + phase.acceleration * seconds;
    const float driven = 0.5F * (phase.start_speed + speed) * seconds;
    profile.stop_short(phase, phase.distance - driven, speed);
  }

  Limits limits = plain_limits();
  Overrides overrides{};
  Block block;
  SpeedProfile profile;
};

/// Returns the time from rest to rest over `length` with acceleration a and at most speed v.
double trapezoid_time(double length, double a, double v) {
  if (length * a < v * v) return 2.0 * std::sqrt(length / a);
  return length / v + v / a;
}

TEST_F(SpeedProfileTest, IsATriangleOnAShortWay) {
  begin(straight_block(1.0, limits, 100.0F));
  const Ride ride = drive();
  EXPECT_NEAR(ride.time, trapezoid_time(1.0, 500.0, 100.0), 1.0e-5);
  EXPECT_NEAR(ride.top_speed, std::sqrt(500.0), 1.0e-3);
  EXPECT_NEAR(ride.distance, 1.0, 1.0e-6);
  EXPECT_EQ(ride.phases, 2);
}

TEST_F(SpeedProfileTest, IsATrapezoidOnALongWay) {
  begin(straight_block(100.0, limits, 100.0F));
  const Ride ride = drive();
  EXPECT_NEAR(ride.time, trapezoid_time(100.0, 500.0, 100.0), 1.0e-5);
  EXPECT_NEAR(ride.top_speed, 100.0, 1.0e-4);
  EXPECT_EQ(ride.phases, 3);
}

TEST_F(SpeedProfileTest, TakesTheClosedFormTimeForRandomLines) {
  for (const std::uint64_t seed : proof::Trials{20'000}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const double speed = random.magnitude(0.1, 199.0);
    limits.acceleration_mm_s2[0] = static_cast<float>(random.magnitude(1.0, 20'000.0));
    const auto a = static_cast<double>(limits.acceleration_mm_s2[0]);
    begin(straight_block(random.magnitude(0.001, 1000.0), limits, static_cast<float>(speed)));
    const auto length = static_cast<double>(block.length);
    const Ride ride = drive();
    ASSERT_TRUE(profile.at_end());
    ASSERT_NEAR(ride.time / trapezoid_time(length, a, speed), 1.0, 1.0e-4);
    ASSERT_NEAR(ride.distance / length, 1.0, 1.0e-5);
    ASSERT_EQ(profile.speed_square(), 0.0F);
  }
}

TEST_F(SpeedProfileTest, GoesFromItsEntryToItsExitSpeed) {
  begin(straight_block(10.0, limits, 100.0F), 2'500.0F, 400.0F);
  const Ride ride = drive();
  // From 20 up to a peak, v² = (400 + 2500 + 2·2·500·10) / 2 limited to 100², and down to 50.
  EXPECT_NEAR(ride.top_speed, std::sqrt((400.0 + 2'500.0 + 2.0 * 500.0 * 10.0) / 2.0), 1.0e-2);
  EXPECT_FLOAT_EQ(profile.speed_square(), 2'500.0F);
}

TEST_F(SpeedProfileTest, HaltsInTheDistanceOfTheBrakingLaw) {
  begin(straight_block(100.0, limits, 100.0F));
  drive_for(0.5F);
  const auto speed_square = static_cast<double>(profile.speed_square());
  EXPECT_NEAR(speed_square, 10'000.0, 1.0);
  const Ride braking = drive(Drive::kHalt);
  EXPECT_NEAR(braking.distance, speed_square / (2.0 * 500.0), 1.0e-3);
  EXPECT_NEAR(braking.time, 100.0 / 500.0, 1.0e-4);
  EXPECT_EQ(profile.speed_square(), 0.0F);
  EXPECT_EQ(profile.next_phase(Drive::kHalt).duration, 0.0F);
}

TEST_F(SpeedProfileTest, GoesOnToTheEndAfterAHalt) {
  begin(straight_block(100.0, limits, 100.0F));
  drive_for(0.4F);
  const Ride braking = drive(Drive::kHalt);
  const Ride rest = drive();
  EXPECT_TRUE(profile.at_end());
  EXPECT_NEAR(rest.top_speed, 100.0, 1.0e-3);
  EXPECT_GT(braking.distance, 9.0);
  EXPECT_EQ(profile.speed_square(), 0.0F);
}

TEST_F(SpeedProfileTest, SlowsDownToALoweredOverride) {
  begin(straight_block(100.0, limits, 100.0F));
  drive_for(0.4F);
  overrides.feed = 0.3F;
  profile.replan(block, limits, {.overrides = overrides}, {});
  const Phase phase = profile.next_phase(Drive::kOn);
  EXPECT_FLOAT_EQ(phase.end_speed_square, 900.0F);
  EXPECT_NEAR(static_cast<double>(phase.acceleration), -500.0, 0.1);
}

/// The speed is constant where the normal is along an axis, and greater where both axes turn the
/// motion.
TEST_F(SpeedProfileTest, DrivesAFullSpeedArcAtItsCentripetalLimit) {
  begin(block_of({.end = place({4.0}), .bulge = 1.0F}, limits), 900.0F, 900.0F);
  const Ride ride = drive();
  const double level = 500.0 * 2.0;  // v²/R = a
  EXPECT_GE(ride.top_speed, std::sqrt(level));
  // Less than if both axes used all of their acceleration for turning, as v must return to the
  // constant speed.
  EXPECT_LE(ride.top_speed, std::sqrt(std::numbers::sqrt2 * level));
  EXPECT_TRUE(profile.at_end());
}

// This holds for any number of spans: a phase for each of them would cost as much as a segment
// does.
TEST_F(SpeedProfileTest, DrivesAnArcThatIsNoFasterAnywhereInOnePhase) {
  begin(block_of({.end = place({40.0}), .bulge = 1.0F}, limits, 20.0F), 400.0F, 400.0F);
  const Phase phase = profile.next_phase(Drive::kOn);
  EXPECT_FLOAT_EQ(phase.distance, block.length);
  EXPECT_GT(phase.passes, 40);
  profile.complete(phase);
  EXPECT_TRUE(profile.at_end());
}

// From the point at which the motion must slow down, the spans are driven one by one.
TEST_F(SpeedProfileTest, SlowsDownInTimeAfterSuchAPhase) {
  begin(block_of({.end = place({40.0}), .bulge = 1.0F}, limits, 80.0F), 0.0F, 6'400.0F);
  const Phase level = profile.next_phase(Drive::kOn);
  EXPECT_GT(level.passes, 40);
  EXPECT_NEAR(level.distance, block.length - 6'400.0F / (2.0F * 500.0F), 1.0F);
  profile.complete(level);
  const Ride braking = drive();
  EXPECT_TRUE(profile.at_end());
  EXPECT_NEAR(braking.distance + static_cast<double>(level.distance),
              static_cast<double>(block.length),
              1.0e-4);
  EXPECT_EQ(profile.speed_square(), 0.0F);
}

TEST_F(SpeedProfileTest, GoesOnFromWhereverSuchAPhaseIsLeft) {
  for (const std::uint64_t seed : proof::Trials{5000}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const auto bulge = static_cast<float>(random.magnitude(0.2, 1.0));
    begin(block_of({.end = place({40.0}), .bulge = bulge}, limits, 20.0F), 400.0F, 400.0F);
    const Phase phase = profile.next_phase(Drive::kOn);
    ASSERT_GT(phase.passes, 8);
    const auto seconds = 0.9F * static_cast<float>(random.unit()) * phase.duration;
    stop_within(phase, seconds);
    const double driven = 20.0 * static_cast<double>(seconds);
    // A third of the rides are slower from here on. The others are unchanged.
    const bool slower = random.chance(0.3);
    if (slower) overrides.feed = 0.5F;
    profile.replan(block, limits, {.overrides = overrides}, {.speed_square = 100.0F});
    const Ride rest = drive();
    ASSERT_TRUE(profile.at_end());
    ASSERT_NEAR((driven + rest.distance) / static_cast<double>(block.length), 1.0, 1.0e-5)
        << "after " << seconds << " s";
    ASSERT_FLOAT_EQ(profile.speed_square(), 100.0F);
    overrides = {};
  }
}

/// Drives over a random block.
class RandomRide : public SpeedProfileTest {
 protected:
  Ride ride_over(std::uint64_t seed) {
    proof::Random random{seed};
    limits = any_limits(random);
    const auto feed = static_cast<float>(random.magnitude(1, 500));
    begin(block_of(any_element(random, {}), limits, feed));
    return drive();
  }

  /// By a known fault, this ride is longer than its block.
  static constexpr std::uint64_t kTooLong = 3460;
};

TEST_F(RandomRide, ReachesTheEndOfTheBlockAtThePlannedSpeed) {
  for (const std::uint64_t seed : proof::Trials{5000, proof::Trials::Range::kKnownFault}) {
    if (seed == kTooLong) continue;
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const Ride ride = ride_over(seed);
    ASSERT_TRUE(profile.at_end());
    EXPECT_NEAR(ride.distance / static_cast<double>(block.length), 1.0, 1.0e-5) << block.length;
    ASSERT_LE(ride.top_speed, static_cast<double>(block.feed) * 1.0001);
    ASSERT_EQ(profile.speed_square(), 0.0F);
  }
}

// If the excess grows, the fault is a new one. The seed of a fault that has disappeared belongs in
// a seed file.
TEST_F(RandomRide, KnownExcessOfLengthNeitherGrowsNorIsGone) {
  const double ratio = ride_over(kTooLong).distance / static_cast<double>(block.length);
  EXPECT_NEAR(ratio, 1.0000685, 1.0e-7);
  std::printf("known excess %.7f of the length of a block, seed %llu\n",
              ratio,
              static_cast<unsigned long long>(kTooLong));
}

TEST_F(SpeedProfileTest, HaltsWithinEveryRandomBlock) {
  for (const std::uint64_t seed : proof::Trials{5000}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    limits = any_limits(random);
    const auto feed = static_cast<float>(random.magnitude(1, 500));
    begin(block_of(any_element(random, {}), limits, feed));
    const Phase first = profile.next_phase(Drive::kOn);
    stop_within(first, 0.5F * first.duration);
    drive(Drive::kHalt);
    ASSERT_EQ(profile.speed_square(), 0.0F);
    drive();
    ASSERT_TRUE(profile.at_end());
  }
}

}  // namespace
}  // namespace cnc::motion

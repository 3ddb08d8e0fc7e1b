#include "planner/motion/segment/step_timing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

double due(const StepTrain& train, int k) {
  const double q16 = static_cast<double>(train.first_q16) + k * 1.0 * train.interval_q16 +
                     0.5 * k * (k - 1.0) * train.growth_q16;
  return q16 / 65536.0;
}

/// A slice in double precision: `from` and `travel` in steps, speeds in steps per tick.
struct Motion {
  double from = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
  double ticks = 0.0;

  [[nodiscard]] double travel() const { return speed * ticks + 0.5 * acceleration * ticks * ticks; }
  [[nodiscard]] AxisSlice slice() const {
    return {.from = StepPosition{std::llround(from * kOneStep)},
            .to = StepPosition{std::llround((from + travel()) * kOneStep)},
            .speed_steps_per_tick = static_cast<float>(speed),
            .ticks = static_cast<float>(ticks)};
  }
  /// Returns the time at which the planned position is `distance` steps from the start.
  [[nodiscard]] double time_to(double distance) const {
    const double root = std::sqrt(std::max(0.0, speed * speed + 2.0 * acceleration * distance));
    return 2.0 * distance / (speed + std::copysign(root, speed));
  }
  /// Returns the time of the k-th half step that is crossed.
  [[nodiscard]] double crossing(const StepPosition& start, int k) const {
    const bool forward = travel() > 0.0;
    const double edge = start.nearest_step() + (forward ? 0.5 + k : -0.5 - k);
    return time_to(edge - static_cast<double>(start.q32()) / kOneStep);
  }
};

class StepTiming : public testing::Test {
 protected:
  /// Returns a slice of up to 90 steps that changes its speed by at most half.
  Motion any_motion() {
    Motion motion{.from = random.between(-1.0e6, 1.0e6), .ticks = random.magnitude(400.0, 4000.0)};
    motion.speed = random.signed_magnitude(1.0e-4, 0.022);
    const double end = motion.speed * random.between(0.5, 1.5);
    motion.acceleration = (end - motion.speed) / motion.ticks;
    return motion;
  }

  proof::Random random{proof::test_seed()};
};

TEST_F(StepTiming, CountsEveryStep) {
  for (int trial = 0; trial < 100'000; ++trial) {
    const AxisSlice slice = any_motion().slice();
    const std::int32_t steps = slice.to.nearest_step() - slice.from.nearest_step();
    ASSERT_EQ(time_steps(slice, 0.0F).count, std::abs(steps)) << "trial " << trial;
  }
}

TEST_F(StepTiming, KeepsEveryStepWithinTwoPercentOfTheSlice) {
  for (int trial = 0; trial < 100'000; ++trial) {
    const Motion motion = any_motion();
    const AxisSlice slice = motion.slice();
    const StepTrain train = time_steps(slice, 0.0F);
    for (int k = 0; k < train.count; ++k) {
      ASSERT_NEAR(due(train, k), motion.crossing(slice.from, k), 0.02 * motion.ticks)
          << "trial " << trial << ", step " << k << " of " << train.count;
    }
  }
}

TEST_F(StepTiming, IsExactForUpToThreeSteps) {
  int seen = 0;
  for (int trial = 0; trial < 200'000; ++trial) {
    const Motion motion = any_motion();
    const AxisSlice slice = motion.slice();
    const StepTrain train = time_steps(slice, 0.0F);
    if (train.count > 3) continue;
    for (int k = 0; k < train.count; ++k, ++seen) {
      ASSERT_NEAR(due(train, k), motion.crossing(slice.from, k), 0.02 + 1.0e-5 * motion.ticks)
          << "trial " << trial << ", step " << k << " of " << train.count;
    }
  }
  EXPECT_GT(seen, 10'000);
}

TEST_F(StepTiming, NeverLetsTheStepsOfOneMotorOvertake) {
  for (int trial = 0; trial < 100'000; ++trial) {
    const StepTrain train = time_steps(any_motion().slice(), 0.0F);
    for (int k = 1; k < train.count; ++k) ASSERT_GT(due(train, k), due(train, k - 1)) << trial;
  }
}

TEST_F(StepTiming, MirrorsWithTheDirection) {
  for (int trial = 0; trial < 20'000; ++trial) {
    const AxisSlice slice = any_motion().slice();
    const AxisSlice mirrored{.from = StepPosition{-slice.from.q32()},
                             .to = StepPosition{-slice.to.q32()},
                             .speed_steps_per_tick = -slice.speed_steps_per_tick,
                             .ticks = slice.ticks};
    const StepTrain there = time_steps(slice, 0.0F);
    const StepTrain back = time_steps(mirrored, 0.0F);
    ASSERT_EQ(there.count, back.count);
    ASSERT_EQ(there.first_q16, back.first_q16);
    ASSERT_EQ(there.interval_q16, back.interval_q16);
  }
}

TEST_F(StepTiming, ShiftsEveryStepBySoMuch) {
  const AxisSlice slice{.from = StepPosition{},
                        .to = StepPosition::whole(10),
                        .speed_steps_per_tick = 0.01F,
                        .ticks = 1000.0F};
  const StepTrain plain = time_steps(slice, 0.0F);
  const StepTrain shifted = time_steps(slice, 0.75F);
  EXPECT_EQ(shifted.first_q16 - plain.first_q16, 49'152);
  EXPECT_EQ(shifted.interval_q16, plain.interval_q16);
}

// Motion to or from standstill has the greatest change of speed.
TEST_F(StepTiming, KeepsEveryStepWithinTheSliceFromStandstill) {
  for (int trial = 0; trial < 50'000; ++trial) {
    Motion motion{.from = random.between(-100.0, 100.0), .ticks = 1000.0};
    const double top = random.signed_magnitude(1.0e-5, 0.02);
    const bool starts = random.chance(0.5);
    motion.speed = starts ? 0.0 : top;
    motion.acceleration = (starts ? top : -top) / motion.ticks;
    const AxisSlice slice = motion.slice();
    const StepTrain train = time_steps(slice, 0.0F);
    for (int k = 0; k < train.count; ++k) {
      ASSERT_GE(due(train, k), 0.0) << "trial " << trial;
      ASSERT_LE(due(train, k), motion.ticks + 0.01) << "trial " << trial;
    }
  }
}

}  // namespace
}  // namespace cnc::motion

#include "planner/motion/motors/backlash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

constexpr float kCellS = 1.0e-3F;

StepPosition at_step(double steps) {
  return StepPosition{static_cast<std::int64_t>(steps * 0x1.0p32)};
}

double to_steps(std::int64_t q32) { return static_cast<double>(q32) * 0x1.0p-32; }

BacklashSetting ten_steps() {
  return {.steps = 10, .rate = 500.0F, .acceleration = 20'000.0F, .starts_towards_plus = true};
}

TEST(Backlash, IsTakenUpWhenTheToolTurnsRoundAndGivenBackLater) {
  Backlash backlash;
  backlash.configure(ten_steps());
  EXPECT_EQ(backlash.follow(at_step(5.0), kCellS), 0);
  EXPECT_EQ(backlash.follow(at_step(4.95), kCellS), 0);
  EXPECT_TRUE(backlash.settled()) << "a twentieth of a step is no reversal";
  for (int i = 0; i < 200; ++i) static_cast<void>(backlash.follow(at_step(4.0), kCellS));
  EXPECT_TRUE(backlash.settled());
  EXPECT_EQ(backlash.follow(at_step(3.0), kCellS), StepPosition::whole(-10).q32());
  for (int i = 0; i < 200; ++i) static_cast<void>(backlash.follow(at_step(3.1), kCellS));
  EXPECT_EQ(backlash.follow(at_step(3.2), kCellS), 0);
}

TEST(Backlash, AssumedAtThePlusSideGoesOnTowardsPlusAtOnce) {
  BacklashSetting setting = ten_steps();
  setting.starts_towards_plus = false;
  Backlash backlash;
  backlash.configure(setting);
  static_cast<void>(backlash.follow(at_step(1.0), kCellS));
  EXPECT_FALSE(backlash.settled());
  EXPECT_EQ(backlash.offset(), 10);
}

TEST(Backlash, LeavesTheToolWhereThePlayLetsIt) {
  Backlash backlash;
  backlash.configure(ten_steps());
  EXPECT_EQ(backlash.moved_by(0, 0), 0);
  EXPECT_EQ(backlash.moved_by(7, 0), 7) << "taken along";
  EXPECT_EQ(backlash.moved_by(3, 7), 7) << "within the play";
  EXPECT_EQ(backlash.moved_by(-5, 7), 5) << "taken along the other way";
}

/// For any motion of the tool, the rate, acceleration and jerk of taking up play stay within their
/// limits. At the end, the axis is at its correct position.
void expect_smooth(std::uint64_t seed) {
  proof::Random random{seed};
  BacklashSetting setting;
  setting.steps = 1 + static_cast<std::int32_t>(random.below(200));
  setting.rate = static_cast<float>(random.magnitude(50.0, 5000.0));
  setting.acceleration = static_cast<float>(random.magnitude(1e3, 1e6));
  if (random.chance(0.5)) setting.jerk = static_cast<float>(random.magnitude(1e5, 1e8));
  Backlash backlash;
  backlash.configure(setting);
  // Much finer than the duration of the quintic, so that differences approximate derivatives.
  const double dt = 1.0e-4;
  std::array<double, 4> last{};
  double tool = 0.0;
  double axis = 0.0;  // Position at which the play leaves the axis.
  double direction = 1.0;
  for (int i = 0; i < 20'000; ++i) {
    if (i < 15'000 && random.chance(2.0e-4)) direction = -direction;
    if (i < 15'000) tool += direction * 0.1;
    std::rotate(last.begin(), last.end() - 1, last.end());
    last[0] = to_steps(backlash.follow(at_step(tool), static_cast<float>(dt)));
    axis = std::clamp(axis, tool + last[0], tool + last[0] + setting.steps);
    ASSERT_LE(std::abs(axis - tool), setting.steps + 1.0e-3);
    if (i < 3) continue;
    // The position is a Q16 fraction of a step, computed in float.
    const double noise = 4.0e-5 + 3.0e-6 * setting.steps;
    ASSERT_LE(std::abs(last[0] - last[1]), static_cast<double>(setting.rate) * dt + noise);
    ASSERT_LE(std::abs(last[0] - 2.0 * last[1] + last[2]),
              static_cast<double>(setting.acceleration) * dt * dt + 2.0 * noise);
  }
  if (!backlash.settled()) return;  // The slowest moves take longer.
  EXPECT_EQ(last[0], backlash.offset());
  EXPECT_NEAR(axis, tool, 1.0 / 16.0 + 1.0e-3) << "however often it turned round meanwhile";
}

TEST(Backlash, IsTakenUpWithinItsShares) {
  const proof::Trials trials{60};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    expect_smooth(seed);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace cnc::motion

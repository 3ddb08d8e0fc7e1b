#include "tests/planner/motion/segment/segmenter_test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cnc::motion {
namespace {

TEST_F(SegmenterTest, HasNothingToHandOutAtFirst) {
  EXPECT_TRUE(segmenter.idle());
  EXPECT_TRUE(segmenter.at_rest());
  EXPECT_FALSE(step());
}

TEST_F(SegmenterTest, TakesTheClosedFormTimeOfATrapezoid) {
  push_to(100.0, 100.0F);
  drive();
  EXPECT_NEAR(seconds(), 100.0 / 100.0 + 100.0 / 500.0, 1.0e-5);
  EXPECT_EQ(steps[0], 25'000);
}

TEST_F(SegmenterTest, DrivesAFullCircleInTheTimeOfItsLength) {
  push({.end = place({40.0}), .bulge = 1.0F}, 50.0F);
  push({.start = goal, .end = place({}), .bulge = 1.0F}, 50.0F);
  drive();
  // The motion accelerates over v²/2a. Only the axes' share of the acceleration differs.
  EXPECT_NEAR(seconds(), 40.0 * std::numbers::pi / 50.0 + 50.0 / 500.0, 0.02);
  EXPECT_EQ(steps[0], 0);
}

// At slow feeds over long paths, the distance for acceleration is very small.
TEST_F(SegmenterTest, DrivesEveryLengthAtEveryFeed) {
  for (const float feed : {0.0002F, 0.01F, 0.2F, 1.0F, 5.0F}) {
    for (const double seconds_long : {0.01, 1.0, 30.0, 600.0}) {
      const double length = static_cast<double>(feed) * seconds_long;
      push_to(static_cast<double>(goal[0].nanometres()) * 1.0e-6 + length, feed);
      for (int slices = 0; slices < 2'000'000 && !segmenter.idle() && step(); ++slices)
        segments.clear();
      EXPECT_TRUE(segmenter.idle()) << "stuck at feed " << feed << " over " << length << " mm";
      EXPECT_TRUE(segmenter.at_rest()) << "feed " << feed << ", " << length << " mm";
      segmenter.reset({});
      goal = {};
    }
  }
}

TEST_F(SegmenterTest, ComesToRestAtTheEndAndNowhereElse) {
  for (int k = 1; k <= 10; ++k) push_to(k, 50.0F);
  drive();
  ASSERT_FALSE(segments.empty());
  EXPECT_TRUE(segments.back().comes_to_rest);
  segments.pop_back();
  EXPECT_TRUE(std::none_of(segments.begin(), segments.end(), [](const Segment& segment) {
    return segment.comes_to_rest;
  }));
}

TEST_F(SegmenterTest, ComesToRestAtAReversal) {
  push_to(5.0, 50.0F);
  push_to(0.0, 50.0F);
  drive();
  EXPECT_EQ(std::count_if(segments.begin(),
                          segments.end(),
                          [](const Segment& segment) { return segment.comes_to_rest; }),
            2);
}

TEST_F(SegmenterTest, HandsOutSlicesOfAtMostAMillisecond) {
  push_to(50.0, 150.0F);
  push({.start = goal, .end = place({60.0, 10.0}), .bulge = 0.4F}, 80.0F);
  drive();
  for (const Segment& segment : segments) {
    EXPECT_GE(segment.ticks, 1U);
    EXPECT_LE(segment.ticks, kMillisecond);
  }
}

TEST_F(SegmenterTest, HandsOutTheOutputsOfABlockOnceAtItsStart) {
  const OutputChanges wanted{
      .raise = 0b0001, .lower = 0b0100, .analog_channel = 1, .analog_value = 5};
  push_to(10.0, 50.0F);
  push_to(20.0, 50.0F, {}, wanted);
  push_to(30.0, 50.0F);
  std::int32_t steps_before = -1;
  int times = 0;
  while (step()) {
    if (!segments.back().outputs.any()) continue;
    ++times;
    EXPECT_EQ(segments.back().outputs, wanted);
    steps_before = steps[0] - segments.back().trains[0].count;
  }
  EXPECT_EQ(times, 1);
  EXPECT_NEAR(steps_before, 2500, 1);
}

TEST_F(SegmenterTest, MergesTheOutputsOfBlocksTooShortForASegment) {
  const double start = 10.0;
  push_to(start, 50.0F);
  push_to(start + 2.0e-6, 50.0F, {}, {.raise = 0b01, .lower = 0b10});
  push_to(start + 4.0e-6, 50.0F, {}, {.raise = 0b10, .lower = 0b01});
  push_to(20.0, 50.0F);
  drive();
  std::uint8_t digital = 0;
  for (const Segment& segment : segments) {
    digital = static_cast<std::uint8_t>((digital | segment.outputs.raise) & ~segment.outputs.lower);
  }
  EXPECT_EQ(digital, 0b10);
}

TEST_F(SegmenterTest, HaltsWithinTheBrakingDistanceAndEndsExactlyAfterwards) {
  push_to(100.0, 100.0F);
  drive(500);
  const std::int32_t at_halt = steps[0];
  segmenter.halt();
  drive();
  EXPECT_TRUE(segmenter.halted());
  EXPECT_FALSE(segmenter.idle());
  EXPECT_TRUE(segments.back().comes_to_rest);
  EXPECT_NEAR((steps[0] - at_halt) / 250.0, 100.0 * 100.0 / (2.0 * 500.0), 0.01);
  segmenter.go_on();
  drive();
  EXPECT_EQ(steps, goal_steps());
  EXPECT_TRUE(segments.back().comes_to_rest);
}

TEST_F(SegmenterTest, FollowsAnOverrideFromTheNextSliceOn) {
  push_to(100.0, 100.0F);
  drive(500);
  segmenter.set_overrides({.feed = 0.5F});
  drive(200);  // The override has reached half by this point.
  const std::uint64_t from_ticks = ticks;
  const std::int32_t from_steps = steps[0];
  drive(100);
  const double speed =
      (steps[0] - from_steps) / 250.0 * kTicksPerSecond / static_cast<double>(ticks - from_ticks);
  EXPECT_NEAR(speed, 50.0, 0.5);
  drive();
  EXPECT_EQ(steps, goal_steps());
}

TEST_F(SegmenterTest, ScalesRapidsByTheirOwnOverride) {
  push_to(100.0);
  segmenter.set_overrides({.feed = 0.1F, .rapid = 0.25F});
  drive();
  EXPECT_NEAR(seconds(), 100.0 / 50.0 + 50.0 / 500.0, 1.0e-3);
}

TEST_F(SegmenterTest, ForgetsEverythingAtAReset) {
  push_to(100.0, 100.0F);
  drive(100);
  const AxisArray<StepPosition> elsewhere{StepPosition::whole(7)};
  segmenter.reset(elsewhere);
  EXPECT_TRUE(segmenter.idle());
  EXPECT_TRUE(segmenter.at_rest());
  EXPECT_FALSE(step());
}

/// Returns the power in the middle of a segment.
double mean_power(const Segment& segment) {
  const PowerCourse& power = segment.power;
  const std::uint32_t stairs = (segment.ticks + power.interval - 1U) / power.interval;
  return power.first + power.growth_q8 / 256.0 * 0.5 * (stairs - 1.0);
}

std::uint16_t greatest_power(const std::vector<Segment>& segments) {
  std::uint16_t greatest = 0;
  for (const Segment& segment : segments) greatest = std::max(greatest, segment.power.first);
  return greatest;
}

TEST_F(SegmenterTest, KeepsAConstantBeamConstant) {
  push_to(20.0, 50.0F, {.duty = 0.5F, .follows_speed = false});
  drive();
  for (const Segment& segment : segments) {
    EXPECT_EQ(segment.power.first, 32'768);
    EXPECT_EQ(segment.power.growth_q8, 0);
  }
}

TEST_F(SegmenterTest, ScalesADynamicBeamByTheSpeedDriven) {
  push_to(20.0, 50.0F, {.duty = 0.5F, .follows_speed = true});
  drive();
  for (std::size_t index = 1; index + 1 < segments.size(); ++index) {
    const Segment& segment = segments[index];
    const double speed = segment.trains[0].count / 250.0 * kTicksPerSecond / segment.ticks;
    // A slice contains whole steps only; one step more or less is 4 mm/s.
    EXPECT_NEAR(
        mean_power(segment), 65'535.0 * 0.5 * speed / 50.0, 65'535.0 * 0.5 * 4.1 * 4 / 50.0);
  }
  EXPECT_NEAR(greatest_power(segments), 32'768, 4);
  EXPECT_LT(segments.front().power.first, 500);
  EXPECT_LT(mean_power(segments.back()), 500.0);
}

TEST_F(SegmenterTest, LetsADynamicBeamClimbEvenlyWithinASlice) {
  push_to(20.0, 50.0F, {.duty = 0.5F, .follows_speed = true});
  drive();
  double after = 0.0;
  for (const Segment& segment : segments) {
    const double half = segment.power.growth_q8 / 256.0 / 2.0;
    EXPECT_NEAR(segment.power.first - half, after, 2.0) << "where the slice before has ended";
    after = 2.0 * mean_power(segment) - (segment.power.first - half);
  }
  EXPECT_NEAR(after, 0.0, 2.0);
}

TEST_F(SegmenterTest, LimitsAnOverriddenBeamToFullPower) {
  push_to(20.0, 50.0F, {.duty = 0.9F, .follows_speed = false});
  segmenter.set_overrides({.power = 2.0F});
  drive();
  EXPECT_EQ(greatest_power(segments), 65'535);
}

}  // namespace
}  // namespace cnc::motion

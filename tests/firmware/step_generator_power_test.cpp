#include "tests/firmware/edge_port.hpp"

namespace cnc {
namespace {

TEST_F(StepGeneratorTest, ChangesPowerWhereTheSegmentStarts) {
  motion::Segment first = even(4000, 4);
  first.power.first = 100;
  motion::Segment second = last(even(4000, 4));
  second.power.first = 200;
  generator.push(first);
  generator.push(second);
  generator.set_rest_power(3);
  run();
  const auto changes = port.of_kind(Kind::kPower);
  ASSERT_EQ(changes.size(), 4U);
  EXPECT_EQ(changes[0].value, 3U);  // The change is immediate, as nothing moves.
  EXPECT_EQ(changes[1].value, 100U);
  EXPECT_EQ(changes[2].value, 200U);
  // From rest the change comes a tick later, because the transition to the segment takes a separate
  // interrupt.
  EXPECT_NEAR(static_cast<double>(changes[2].tick - changes[1].tick), 4000.0, 1.0);
  EXPECT_EQ(changes[3].value, 3U);
  EXPECT_NEAR(static_cast<double>(changes[3].tick - changes[1].tick), 8000.0, 1.0);
}

TEST_F(StepGeneratorTest, ChangesPowerAtTheLevelsOfASegment) {
  motion::Segment segment = last(even(4000, 97));
  segment.power.first = 100;
  segment.level_count = 3;
  segment.levels = {
      {{.from = 200, .duty = 300}, {.from = 333, .duty = 0}, {.from = 3999, .duty = 7}}};
  generator.push(segment);
  run();
  const auto changes = port.of_kind(Kind::kPower);
  ASSERT_EQ(changes.size(), 5U);
  const std::uint64_t begin = changes[0].tick;
  EXPECT_EQ(changes[0].value, 100U);
  for (std::size_t i = 0; i < segment.level_count; ++i) {
    EXPECT_EQ(changes[i + 1].value, segment.levels[i].duty);
    EXPECT_NEAR(static_cast<double>(changes[i + 1].tick - begin), segment.levels[i].from, 1.0);
  }
  EXPECT_EQ(changes[4].value, 0U);
  EXPECT_EQ(port.position[0], 97);
}

/// The motion is so slow that the steps alone would not call the interrupt often enough.
TEST_F(StepGeneratorTest, LetsThePowerClimbEveryHundredMicroseconds) {
  motion::Segment segment = last(even(4000, 1));
  segment.power = {.growth_q8 = 10 * 256, .first = 5, .interval = 400};
  generator.push(segment);
  run();
  const auto changes = port.of_kind(Kind::kPower);
  ASSERT_EQ(changes.size(), 11U);
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_EQ(changes[k].value, 5 + 10 * k);
    EXPECT_NEAR(static_cast<double>(changes[k].tick), 400.0 * static_cast<double>(k), 20.0);
  }
  EXPECT_EQ(changes.back().value, 0U);
  EXPECT_EQ(port.position[0], 1);
}

TEST_F(StepGeneratorTest, KeepsPulsesWholeWhereThePowerChanges) {
  motion::Segment segment = last(even(4000, 97));
  segment.power = {.growth_q8 = 256, .first = 5, .interval = 13};
  generator.push(segment);
  run();
  const auto raised = port.of_kind(Kind::kRaise);
  const auto lowered = port.of_kind(Kind::kLower);
  ASSERT_EQ(raised.size(), 97U);
  ASSERT_EQ(lowered.size(), 97U);
  for (std::size_t k = 0; k < 97; ++k) {
    EXPECT_EQ(lowered[k].tick - raised[k].tick, 20U);
    if (k > 0) {
      EXPECT_GE(raised[k].tick - lowered[k - 1].tick, 20U);
    }
  }
}

/// Steps are 40 ticks apart, 20 high and 20 low. At any phase the output must not be late.
TEST_F(StepGeneratorTest, ChangesPowerInTheCourseOfASlot) {
  for (std::uint32_t ticks = 4000; ticks < 4040; ++ticks) {
    port = {};
    motion::Segment first = even(4000, 100);
    first.ticks = ticks;
    first.power.first = 100;
    motion::Segment second = last(even(4000, 100));
    second.power.first = 200;
    generator.push(first);
    generator.push(second);
    run();
    const auto changes = port.of_kind(Kind::kPower);
    ASSERT_EQ(changes.size(), 3U);
    EXPECT_NEAR(static_cast<double>(changes[1].tick - changes[0].tick), ticks, 1.0);
  }
}

TEST_F(StepGeneratorTest, EndsASlopeAtZeroRatherThanBelow) {
  motion::Segment segment = last(even(4000, 4));
  segment.power = {.growth_q8 = -200, .first = 1, .interval = 400};
  generator.push(segment);
  run();
  for (const Edge& change : port.of_kind(Kind::kPower)) EXPECT_LE(change.value, 1U);
}

TEST_F(StepGeneratorTest, GoesToItsRestPowerWhenStarved) {
  motion::Segment segment = even(4000, 4);
  segment.power.first = 50'000;
  generator.push(segment);
  run();
  EXPECT_EQ(port.power, 0);
}

TEST_F(StepGeneratorTest, KeepsThePowerOfTheMotionWhileItRuns) {
  motion::Segment segment = last(even(4000, 4));
  segment.power.first = 500;
  generator.push(segment);
  run(100);
  generator.set_rest_power(9);
  EXPECT_EQ(port.power, 500);
  run();
  EXPECT_EQ(port.power, 9);
}

TEST_F(StepGeneratorTest, DarkensTheOutputWithinAnInterrupt) {
  motion::Segment bright = even(4000, 40);
  bright.power.first = 30'000;
  generator.push(bright);
  generator.push(last(bright));
  run(2000);
  ASSERT_EQ(port.power, 30'000);
  generator.block_power(true);
  run(110);
  EXPECT_EQ(port.power, 0);
  run();
  EXPECT_EQ(port.power, 0);
  EXPECT_EQ(port.position[0], 80);
  generator.set_rest_power(500);
  EXPECT_EQ(port.power, 0);
  generator.block_power(false);
  EXPECT_EQ(port.power, 500);
}

TEST_F(StepGeneratorTest, KnowsAtWhichTickOfTheMotionTheLightEnded) {
  motion::Segment bright = even(4000, 40);
  bright.power.first = 30'000;
  generator.push(bright);
  generator.push(bright);
  generator.push(last(bright));
  EXPECT_EQ(generator.ticks_handed_over(), 12'000U);
  run(5950);
  ASSERT_EQ(port.power, 30'000);
  generator.block_power(true);
  const auto before = port.position[0];
  run(1000);
  generator.block_power(true);
  run();
  EXPECT_NEAR(generator.light_ended(), 5950.0, 105.0);
  EXPECT_NEAR(before, 0.01 * generator.light_ended(), 1.5);
}

TEST_F(StepGeneratorTest, SaysOfAnOutputBlockedAtRestThatTheLightEndedThere) {
  generator.push(last(even(4000, 40)));
  run();
  generator.block_power(true);
  EXPECT_EQ(generator.light_ended(), 4000U);
  generator.block_power(false);
  generator.push(last(even(4000, 40)));
  run();
  generator.block_power(true);
  EXPECT_EQ(generator.light_ended(), 8000U);
}

/// The power is delayed by the same time as the motors' steps.
TEST_F(StepGeneratorTest, CountsTheBeamsDelaysAsLight) {
  generator.set_beam_timing({.lag = 1000, .on_delay = 0, .off_delay = 300});
  motion::Segment bright = even(4000, 40);
  bright.power.first = 30'000;
  generator.push(bright);
  generator.push(last(bright));
  run(3000);
  generator.block_power(true);
  run();
  EXPECT_NEAR(generator.light_ended(), 3000.0 + 1300.0, 105.0);
}

}  // namespace
}  // namespace cnc

#include "tests/firmware/edge_port.hpp"

namespace cnc {
namespace {

TEST_F(StepGeneratorTest, DoesNothingWithoutSegments) {
  run();
  EXPECT_FALSE(generator.running());
  EXPECT_TRUE(port.edges.empty());
}

TEST_F(StepGeneratorTest, EndsWhereItIsToldTo) {
  motion::Segment segment = even(4000, 40);
  segment.trains[3] = even(4000, 7).trains[0];
  segment.negative = 0b1000;
  generator.push(last(segment));
  run();
  EXPECT_EQ(port.position, (AxisArray<std::int32_t>{40, 0, 0, -7, 0, 0}));
  EXPECT_EQ(generator.position(), port.position);
  EXPECT_FALSE(generator.running());
  EXPECT_FALSE(generator.take_starved());
}

TEST_F(StepGeneratorTest, TellsOnceThatItStarved) {
  generator.push(even(4000, 40));
  run();
  EXPECT_EQ(port.position[0], 40);
  EXPECT_TRUE(generator.take_starved());
  EXPECT_FALSE(generator.take_starved());
}

TEST_F(StepGeneratorTest, IsNotStarvedByARestBetweenMoves) {
  generator.push(last(even(4000, 40)));
  run();
  generator.push(last(even(4000, 40)));
  run();
  EXPECT_FALSE(generator.take_starved());
  EXPECT_EQ(port.position[0], 80);
}

/// The rest of a motion that was cut off would begin at full speed, and with its light.
TEST_F(StepGeneratorTest, StaysWhereItStarvedUntilItIsAborted) {
  motion::Segment segment = even(4000, 40);
  segment.power.first = 50'000;
  generator.push(segment);
  run();
  segment.comes_to_rest = true;
  generator.push(segment);
  run();
  EXPECT_EQ(port.position[0], 40);
  EXPECT_EQ(port.power, 0);
  EXPECT_TRUE(generator.take_starved());
  EXPECT_TRUE(generator.running());
  generator.abort();
  run();
  EXPECT_FALSE(generator.running());
  generator.push(segment);
  run();
  EXPECT_EQ(port.position[0], 80) << "what waited was dropped";
  EXPECT_FALSE(generator.take_starved());
  EXPECT_FALSE(generator.running());
}

TEST_F(StepGeneratorTest, CountsTheTicksThatWait) {
  generator.push(even(4000, 4));
  generator.push(last(even(3000, 4)));
  EXPECT_EQ(generator.ticks_waiting(), 7000U);
  run(100);
  EXPECT_EQ(generator.ticks_waiting(), 3000U);
  run();
  EXPECT_EQ(generator.ticks_waiting(), 0U);
}

TEST_F(StepGeneratorTest, IsFullWhenAllButTheOneInPlayAreTaken) {
  for (int k = 0; k < 63; ++k) {
    EXPECT_FALSE(generator.full());
    generator.push(even(40, 1));
  }
  EXPECT_TRUE(generator.full());
}

TEST_F(StepGeneratorTest, KeepsATimeWithoutSteps) {
  for (int k = 0; k < 3; ++k) generator.push({.ticks = 4'000});
  generator.push(last(even(400, 1)));
  run();
  EXPECT_NEAR(static_cast<double>(port.of_kind(Kind::kRaise).at(0).tick), 12'200.0, 1.0);
}

/// What memory that turned over may make of a segment: each would leave the beam on without a step.
TEST_F(StepGeneratorTest, PlaysNoSegmentLongerThanASlice) {
  motion::Segment segment = last(even(4000, 4));
  segment.ticks |= 1U << 16U;
  generator.push(segment);
  EXPECT_DEATH(run(), "contract failed");
}

TEST_F(StepGeneratorTest, WaitsForNoStepBeyondTheEnd) {
  motion::Segment segment = last(even(4000, 4));
  segment.trains[0].interval_q16 |= 1 << 29;
  generator.push(segment);
  EXPECT_DEATH(run(), "contract failed");
}

TEST_F(StepGeneratorTest, DrivesNoMotorWithoutSteps) {
  PlayableSegment segment{.segment = even(4000, 4)};
  segment.prepare();
  segment.moving |= 1U << 3U;
  StepTrains trains;
  trains.begin(segment);
  EXPECT_DEATH(static_cast<void>(trains.take_before(100)), "contract failed");
}

TEST_F(StepGeneratorTest, AbortsAtOnceAndForgetsTheRest) {
  generator.push(even(4000, 40));
  generator.push(last(even(4000, 40)));
  generator.set_rest_power(7);
  run(2000);
  const std::int32_t at_abort = port.position[0];
  generator.abort();
  run(200);
  EXPECT_FALSE(generator.running());
  EXPECT_LE(port.position[0], at_abort + 1);
  EXPECT_EQ(generator.position(), port.position);
  EXPECT_EQ(port.power, 7);
  EXPECT_EQ(generator.ticks_waiting(), 0U);
  EXPECT_FALSE(generator.take_starved());
}

TEST_F(StepGeneratorTest, LeavesNoPulseHighAfterAnAbort) {
  generator.push(last(even(4000, 40)));
  run(55);  // Within the first pulse.
  generator.abort();
  run();
  ASSERT_FALSE(port.of_kind(Kind::kRaise).empty());
  EXPECT_EQ(port.of_kind(Kind::kRaise).size(), port.of_kind(Kind::kLower).size());
}

TEST_F(StepGeneratorTest, IsNotAbortedLaterByAnAbortAtRest) {
  generator.abort();
  generator.push(last(even(4000, 40)));
  run();
  EXPECT_EQ(port.position[0], 40);
}

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
  EXPECT_EQ(changes[0].value, 3U);  // At once, as nothing moves.
  EXPECT_EQ(changes[1].value, 100U);
  EXPECT_EQ(changes[2].value, 200U);
  // From rest a tick later: the segment is gone over to first, in an interrupt of its own.
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

/// Slow, so that the steps alone would not wake the interrupt often enough.
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

/// Steps 40 ticks apart, 20 high and 20 low: whatever the phase, the output is not late.
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

TEST_F(StepGeneratorTest, ChangesOutputsWhereTheSegmentStarts) {
  motion::Segment second = last(even(4000, 4));
  second.outputs = {.raise = 0b10, .lower = 0b01, .analog_channel = 2, .analog_value = 77};
  port.digital = 0b01;
  generator.push(even(4000, 4));
  generator.push(second);
  run();
  EXPECT_EQ(port.digital, 0b10);
  EXPECT_EQ(port.analog, 77);
  const auto changes = port.of_kind(Kind::kOutputs);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NEAR(static_cast<double>(changes[0].tick), 4000.0, 1.0);
}

TEST_F(StepGeneratorTest, LatchesThePositionOfTheFirstContact) {
  port.contact_from = 13;
  generator.arm_probe(true);
  generator.push(last(even(4000, 40)));
  run();
  ASSERT_TRUE(generator.probe_hit());
  EXPECT_EQ(generator.probe_position()[0], 13);
  EXPECT_EQ(port.position[0], 40);
}

TEST_F(StepGeneratorTest, LatchesTheReleaseWhenAskedTo) {
  motion::Segment back = last(even(4000, 40));
  back.negative = 1;
  port.contact_from = -12;
  generator.arm_probe(false);
  generator.push(back);
  run();
  ASSERT_TRUE(generator.probe_hit());
  EXPECT_EQ(generator.probe_position()[0], -13);
}

TEST_F(StepGeneratorTest, LatchesNothingWhenDisarmed) {
  port.contact_from = 5;
  generator.arm_probe(true);
  generator.disarm_probe();
  generator.push(last(even(4000, 40)));
  run();
  EXPECT_FALSE(generator.probe_hit());
}

TEST_F(StepGeneratorTest, LatchesAnewWhenArmedAgain) {
  port.contact_from = 5;
  generator.arm_probe(true);
  generator.push(last(even(4000, 40)));
  run();
  ASSERT_TRUE(generator.probe_hit());
  generator.arm_probe(true);
  EXPECT_FALSE(generator.probe_hit());
}

TEST_F(StepGeneratorTest, StepsSecondMotorsWithTheirFirst) {
  generator.set_second_motors(1);
  generator.push(last(even(4000, 40)));
  generator.push(last(even(4000, 7, 1)));
  run();
  EXPECT_EQ(port.position[0], 40);
  EXPECT_EQ(port.second_position[0], 40);
  EXPECT_EQ(port.second_position[1], 0);
}

TEST_F(StepGeneratorTest, LatchesTheStepAtWhichASwitchCloses) {
  port.switch_from = 13;
  generator.watch_switches(1, 0);
  generator.push(last(even(4000, 40)));
  run();
  EXPECT_EQ(generator.switches_found(), 1);
  EXPECT_EQ(generator.switch_position(0), 13);
  EXPECT_EQ(port.position[0], 40) << "braking is not its business";
}

TEST_F(StepGeneratorTest, LetsOneMotorWaitAtItsSwitchForTheOther) {
  port.switch_from = 13;
  port.second_switch_from = 20;
  generator.set_second_motors(1);
  generator.watch_switches(1, 1);
  generator.push(even(1400, 14));
  generator.push(last(even(2600, 26)));
  run(1400);
  EXPECT_EQ(generator.switches_found(), 0);
  EXPECT_EQ(generator.switches_half_found(), 1);
  run();
  EXPECT_EQ(generator.switches_found(), 1);
  EXPECT_EQ(generator.switches_half_found(), 0);
  EXPECT_EQ(generator.switch_position(0), 20);
  EXPECT_EQ(generator.switch_skew(0), 7);
  EXPECT_EQ(port.second_position[0], 40);
  EXPECT_EQ(port.position[0], 40 - 7) << "both stand equally far beyond their switches";
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

/// The light is as late as the motors' steps have to wait for it.
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

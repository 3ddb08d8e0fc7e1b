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

/// Otherwise the rest of a motion that was cut off would begin at full speed, with the beam on.
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

/// Tests values that a flipped bit in memory may give a segment. Each would leave the beam on
/// without a step.
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
  run(55);  // This is within the first pulse.
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

}  // namespace
}  // namespace cnc

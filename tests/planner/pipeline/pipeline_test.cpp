#include "tests/planner/pipeline/pipeline_test.hpp"

#include <memory>

#include "tests/support/trials.hpp"

namespace cnc {
namespace {

using motion::place;

TEST_F(PipelineTest, DrivesElementsToTheirEnd) {
  EXPECT_TRUE(pipeline->empty());
  EXPECT_TRUE(go(place({10.0, 5.0})).value());
  EXPECT_TRUE(go(place({10.0, 5.0, 2.0})).value());
  EXPECT_EQ(pipeline->target(), place({10.0, 5.0, 2.0}));
  finish();
  EXPECT_EQ(motors, steps_at(place({10.0, 5.0, 2.0})));
  EXPECT_EQ(pipeline->blocks_taken(), 3U) << "an arc in the plane of both lines between them";
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    EXPECT_EQ(pipeline->place()[axis].nearest_step(), motors[axis]);
  }
}

TEST_F(PipelineTest, AnElementThatDoesNotMoveIsDone) {
  EXPECT_FALSE(go(pipeline->target()).value());
  EXPECT_TRUE(pipeline->empty());
}

TEST_F(PipelineTest, RefusesAnEndOutOfTheMotorsRange) {
  const Position before = pipeline->target();
  Position far = before;
  far[0] = limits.scale[0].place_of(AxisScale::kMaxSteps) + Coordinate{1'000'000};
  const auto refused = go(far);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error(), motion::MotionError::kBeyondMotorRange);
  EXPECT_EQ(pipeline->target(), before);
  EXPECT_TRUE(pipeline->empty());
}

TEST_F(PipelineTest, RefusesAnArcThatTurnedByARightAngleIsOutOfTheMotorsRange) {
  limits.scale[0] = AxisScale{100'000.0F};
  const path::PathItem arc{
      .request = {.element = {.end = place({0.0, 20'000.0}), .bulge = 0.001F}, .feed_mm_s = 50.0F}};
  const auto refused = pipeline->append(arc);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error(), motion::MotionError::kBeyondMotorRange);
  EXPECT_TRUE(pipeline->empty());
}

// The next element decides how a line ends, so the line waits for it. After 5 ms without a line
// from the sender, the line is driven without a next element.
TEST_F(PipelineTest, HoldsTheLastElementBackUntilTheSenderIsSilent) {
  ASSERT_TRUE(go(place({10.0})).value());
  for (int i = 0; i < 4; ++i) EXPECT_EQ(cycle(), 0) << i;
  EXPECT_GT(cycle(), 0);
}

TEST_F(PipelineTest, DrivesAtOnceWhatIsFlushed) {
  ASSERT_TRUE(go(place({10.0})).value());
  pipeline->flush();
  EXPECT_GT(cycle(), 0);
}

// Otherwise a burst of short lines would take more processor time than the segments last.
TEST_F(PipelineTest, TakesEightElementsInACycle) {
  for (int i = 1; i <= 8; ++i) {
    ASSERT_TRUE(pipeline->has_room()) << i;
    ASSERT_TRUE(go(place({10.0 * i})).value());
  }
  EXPECT_FALSE(pipeline->has_room());
  pipeline->attend(kCycleUs);
  EXPECT_TRUE(pipeline->has_room());
}

TEST_F(PipelineTest, IsHeldAndGoesOnToTheSamePlace) {
  ASSERT_TRUE(go(place({20.0, 10.0})).value());
  pipeline->flush();
  cycle(150);
  pipeline->halt();
  for (int i = 0; i < kMaxCycles && !pipeline->held(); ++i) cycle();
  ASSERT_TRUE(pipeline->held());
  EXPECT_TRUE(rests);
  EXPECT_FALSE(pipeline->empty());
  EXPECT_EQ(cycle(), 0);
  EXPECT_GT(motors[0], 0);
  EXPECT_LT(motors[0], steps_at(place({20.0}))[0]);
  pipeline->go_on();
  finish();
  EXPECT_EQ(motors, steps_at(place({20.0, 10.0})));
}

TEST_F(PipelineTest, DropsTheRestOfAHeldMotion) {
  ASSERT_TRUE(go(place({20.0})).value());
  ASSERT_TRUE(go(place({20.0, 20.0})).value());
  pipeline->flush();
  cycle(150);
  ASSERT_TRUE(go(place({40.0, 20.0})).value()) << "which is held back";
  pipeline->halt();
  for (int i = 0; i < kMaxCycles && !pipeline->held(); ++i) cycle();
  pipeline->restart(motors, motors);
  EXPECT_TRUE(pipeline->empty());
  EXPECT_EQ(pipeline->target(), pipeline->place_of(motors));
  pipeline->go_on();
  ASSERT_TRUE(go(place({-3.0})).value());
  finish();
  EXPECT_EQ(motors, steps_at(place({-3.0})));
}

TEST_F(PipelineTest, DrivesHalfAsFastUnderAnOverrideOfAHalf) {
  ASSERT_TRUE(go(place({100.0})).value());
  finish();
  const double usual = seconds();
  ticks = 0;
  pipeline->set_overrides({.feed = 0.5F});
  ASSERT_TRUE(go(place({0.0})).value());
  finish();
  EXPECT_NEAR(seconds(), 2.0 * usual, 0.1 * usual);
}

TEST_F(PipelineTest, TakesUpBacklashWhereAnAxisReverses) {
  motion::MotorStageSetting setting;
  setting.max_steps_per_s.fill(50'000.0F);
  setting.backlash[0] = {.steps = 8, .rate = 5'000.0F, .acceleration = 50'000.0F};
  EXPECT_TRUE(pipeline->configure(setting));
  EXPECT_FALSE(pipeline->configure(setting)) << "nothing changes";
  ASSERT_TRUE(go(place({5.0})).value());
  finish();
  EXPECT_EQ(motors, steps_at(place({5.0})));
  ASSERT_TRUE(go(place({1.0})).value());
  finish();
  EXPECT_EQ(motors[0], steps_at(place({1.0}))[0] - 8);
}

// The situation is as after homing: the counters have other positions, and the play is where it
// was.
TEST_F(PipelineTest, StartsAgainElsewhereWithItsBacklash) {
  motion::MotorStageSetting setting;
  setting.max_steps_per_s.fill(50'000.0F);
  setting.backlash[0] = {.steps = 8, .rate = 5'000.0F, .acceleration = 50'000.0F};
  pipeline->configure(setting);
  ASSERT_TRUE(go(place({-2.0})).value());
  finish();
  const Steps tool = steps_at(place({7.0}));
  motors = tool;
  motors[0] -= 8;
  pipeline->restart(tool, motors);
  ASSERT_TRUE(go(place({5.0})).value());
  finish();
  EXPECT_EQ(motors[0], steps_at(place({5.0}))[0] - 8);
  ASSERT_TRUE(go(place({6.0})).value());
  finish();
  EXPECT_EQ(motors[0], steps_at(place({6.0}))[0]);
}

TEST_F(PipelineTest, KnowsTheLineThatIsDriven) {
  EXPECT_EQ(pipeline->line().number, 0U);
  ASSERT_TRUE(
      pipeline
          ->append({.request = {.element = {.end = place({1.0})}, .feed_mm_s = 50.0F, .line = {7}}})
          .value());
  EXPECT_EQ(pipeline->line().number, 7U);
  finish();
  EXPECT_EQ(pipeline->line().number, 0U);
}

// For any elements in any bursts, each step is driven, and a hold loses none.
TEST_F(PipelineTest, DrivesEveryRandomPathToItsEnd) {
  for (const std::uint64_t seed : proof::Trials{100}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    limits = motion::any_limits(random);
    if (random.chance(0.5)) limits.jerk_mm_s3.fill(static_cast<float>(random.magnitude(2e3, 2e6)));
    pipeline->restart({}, {});
    motors = {};
    for (int i = 0; i < 40; ++i) {
      wait_for_room();
      const PathElement element = motion::any_element(random, pipeline->target());
      ASSERT_TRUE(pipeline
                      ->append({.request = {.element = element, .feed_mm_s = 200.0F},
                                .tolerance = path::tolerance_within(0.01F, 0.002F)})
                      .ok());
      if (random.chance(0.1)) pipeline->halt();
      if (random.chance(0.3)) cycle(static_cast<int>(random.below(50)));
      pipeline->go_on();
    }
    finish();
    ASSERT_EQ(motors, steps_at(pipeline->target()));
  }
}

}  // namespace
}  // namespace cnc

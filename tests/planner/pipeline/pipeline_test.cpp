#include "planner/pipeline/pipeline.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

using motion::place;
using motion::Segment;
using Steps = AxisArray<std::int32_t>;

constexpr std::int32_t kCycleUs = 1000;
constexpr int kMostCycles = 100'000;

/// A pipeline and motors that count its steps; no drive, no firmware.
class PipelineTest : public testing::Test {
 protected:
  /// Straight on from the target, at 50 mm/s.
  Result<bool, motion::MotionError> go(const Position& end) {
    return pipeline->append(
        {.request = {.element = {.start = pipeline->target(), .end = end}, .feed_mm_s = 50.0F},
         .tolerance = path::tolerance_within(0.01F, 0.002F)});
  }
  /// The next segment; false if there is none.
  bool step() {
    Segment segment;
    if (!pipeline->next(segment)) return false;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const auto count = static_cast<std::int32_t>(segment.trains[axis].count);
      motors[axis] += (segment.negative >> axis & 1U) != 0 ? -count : count;
    }
    ticks += segment.ticks;
    rests = segment.comes_to_rest;
    return true;
  }
  /// One cycle of a main loop that takes at most so many segments.
  int cycle(int most = 100) {
    pipeline->attend(kCycleUs);
    int taken = 0;
    while (taken < most && step()) ++taken;
    return taken;
  }
  /// All that is appended, to its end.
  void finish() {
    for (int i = 0; i < kMostCycles && !pipeline->empty(); ++i) {
      pipeline->flush();
      cycle();
    }
    ASSERT_TRUE(pipeline->empty());
    EXPECT_TRUE(rests);
  }
  void wait_for_room() {
    for (int i = 0; i < kMostCycles && !pipeline->has_room(); ++i) cycle(1);
    ASSERT_TRUE(pipeline->has_room());
  }
  [[nodiscard]] Steps steps_at(const Position& position) const {
    Steps steps{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      steps[axis] = limits.scale[axis].steps_at(position[axis])->nearest_step();
    }
    return steps;
  }
  [[nodiscard]] double seconds() const {
    return static_cast<double>(ticks) / motion::kTicksPerSecond;
  }

  motion::Limits limits = motion::plain_limits();
  std::unique_ptr<Pipeline> pipeline = std::make_unique<Pipeline>(limits);
  Steps motors{};
  std::uint64_t ticks = 0;
  bool rests = true;
};

TEST_F(PipelineTest, DrivesElementsToTheirEnd) {
  EXPECT_TRUE(pipeline->empty());
  EXPECT_TRUE(go(place({10.0, 5.0})).value());
  EXPECT_TRUE(go(place({10.0, 5.0, 2.0})).value());
  EXPECT_EQ(pipeline->target(), place({10.0, 5.0, 2.0}));
  finish();
  EXPECT_EQ(motors, steps_at(place({10.0, 5.0, 2.0})));
  EXPECT_EQ(pipeline->blocks_taken(), 2U);
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
  far[0] = limits.scale[0].place_of(AxisScale::kMostSteps) + Coordinate{1'000'000};
  const auto refused = go(far);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error(), motion::MotionError::kBeyondMotorRange);
  EXPECT_EQ(pipeline->target(), before);
  EXPECT_TRUE(pipeline->empty());
}

// What follows decides how a line ends, so it waits for it; a sender that is silent for 5 ms has
// no more.
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

// Else a burst of short lines would take the processor longer than the segments last.
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
  for (int i = 0; i < kMostCycles && !pipeline->held(); ++i) cycle();
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
  for (int i = 0; i < kMostCycles && !pipeline->held(); ++i) cycle();
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
  setting.most_steps_per_s.fill(50'000.0F);
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

// As after homing: the counters say another place, and the play is where it was.
TEST_F(PipelineTest, StartsAgainElsewhereWithItsBacklash) {
  motion::MotorStageSetting setting;
  setting.most_steps_per_s.fill(50'000.0F);
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

// Whatever comes, in whatever bursts: every step of it is driven, and none is lost by a hold.
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

/// A chain of lines and arcs that is halted on its way.
class TakenBackTest : public PipelineTest {
 protected:
  void begin(int elements) {
    for (int i = 0; i < elements; ++i) {
      wait_for_room();
      const Position& from = pipeline->target();
      Position to = from;
      to[0] += Coordinate{2'000'000};
      to[1] += Coordinate{i % 2 == 0 ? 0 : 1'000'000};
      EXPECT_TRUE(pipeline
                      ->append({.request = {.element = {.start = from,
                                                        .end = to,
                                                        .bulge = i % 3 == 0 ? 0.4F : 0.0F},
                                            .feed_mm_s = 50.0F}})
                      .ok());
    }
  }
  void halt_after(double mm) {
    while (travelled_mm() < mm) cycle(1);
    pipeline->keep_path(true);
    pipeline->halt();
    while (!pipeline->held()) cycle(1);
  }
  [[nodiscard]] double travelled_mm() const {
    return static_cast<double>(pipeline->travelled()) / static_cast<double>(motion::kUnitsPerMm);
  }
};

TEST_F(TakenBackTest, GoesOnFromWhereItWasAsIfItHadBeenHaltedThere) {
  begin(20);
  std::vector<std::pair<double, Steps>> way;
  while (travelled_mm() < 17.0) {
    cycle(1);
    way.emplace_back(travelled_mm(), motors);
  }
  halt_after(17.0);
  const double stood = travelled_mm();
  const double back = stood - way[way.size() / 2].first;
  EXPECT_EQ(pipeline->go_back(static_cast<motion::PathUnits>(
                back * static_cast<double>(motion::kUnitsPerMm))),
            0.0F);
  EXPECT_NEAR(travelled_mm(), stood - back, 1.0e-6);
  EXPECT_TRUE(pipeline->held());
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto step = pipeline->place()[axis].nearest_step();
    EXPECT_NEAR(step, way[way.size() / 2].second[axis], 1);
    motors[axis] = step;
  }
  pipeline->go_on();
  for (std::size_t i = way.size() / 2; i < way.size(); ++i) {
    while (travelled_mm() < way[i].first && step()) {
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_NEAR(motors[axis], way[i].second[axis], 20) << travelled_mm();
    }
  }
  finish();
  EXPECT_EQ(motors, steps_at(pipeline->target()));
}

TEST_F(TakenBackTest, SaysHowMuchIsNotKnownAnyMore) {
  begin(300);
  halt_after(500.0);
  const double stood = travelled_mm();
  const float unknown_mm = pipeline->go_back(
      static_cast<motion::PathUnits>(400.0 * static_cast<double>(motion::kUnitsPerMm)));
  EXPECT_GT(unknown_mm, 1.0F);
  EXPECT_LT(unknown_mm, 400.0F - 2.0F * motion::kBlocksKept);
  EXPECT_NEAR(travelled_mm(), stood - 400.0 + static_cast<double>(unknown_mm), 1.0e-3);
  motors = {};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    motors[axis] = pipeline->place()[axis].nearest_step();
  }
  pipeline->go_on();
  pipeline->keep_path(false);
  finish();
  EXPECT_EQ(motors, steps_at(pipeline->target()));
}

TEST_F(TakenBackTest, TakesBackWhatWasDrivenToTheEnd) {
  begin(3);
  finish();
  EXPECT_EQ(pipeline->go_back(motion::to_units(3.0F)), 0.0F);
  EXPECT_FALSE(pipeline->empty());
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    motors[axis] = pipeline->place()[axis].nearest_step();
  }
  finish();
  EXPECT_EQ(motors, steps_at(pipeline->target()));
}

TEST_F(TakenBackTest, TakesNothingBackAfterAllWasForgotten) {
  begin(3);
  finish();
  pipeline->restart(motors, motors);
  EXPECT_EQ(pipeline->go_back(motion::to_units(3.0F)), 3.0F);
  EXPECT_TRUE(pipeline->empty());
}

}  // namespace
}  // namespace cnc

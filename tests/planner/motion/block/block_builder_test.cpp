#include "planner/motion/block/block_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "planner/motion/lookahead/spans.hpp"
#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

TEST(BlockBuilder, MeasuresALineInAllSixAxes) {
  const Block block = block_of({.end = place({3.0, 0.0, 0.0, 4.0})}, plain_limits());
  EXPECT_FLOAT_EQ(block.length, 5.0F);
  EXPECT_FLOAT_EQ(block.direction[0], 0.6F);
  EXPECT_FLOAT_EQ(block.direction[3], 0.8F);
  EXPECT_FALSE(block.turns());
}

TEST(BlockBuilder, CountsTheFeedAlongXYZ) {
  const Block block = block_of({.end = place({3.0, 0.0, 0.0, 4.0})}, plain_limits(), 30.0F);
  EXPECT_FLOAT_EQ(block.feed, 50.0F);
}

TEST(BlockBuilder, CountsTheFeedAlongABCWhenThoseAloneMove) {
  const Block block = block_of({.end = place({0, 0, 0, 3.0, 4.0})}, plain_limits(), 30.0F);
  EXPECT_FLOAT_EQ(block.feed, 30.0F);
}

TEST(BlockBuilder, CountsTheFeedAlongTheArc) {
  PathElement half_turn{.end = place({2.0}), .bulge = 1.0F};
  half_turn.end[4] = Coordinate{5'000'000};
  const Block block = block_of(half_turn, plain_limits(), 10.0F);
  const double six = std::hypot(3.14159265, 5.0);
  EXPECT_NEAR(static_cast<double>(block.length), six, 1.0e-6);
  EXPECT_NEAR(static_cast<double>(block.feed), 10.0 * six / 3.14159265, 1.0e-5);
}

TEST(BlockBuilder, TakesARapidForWhatHasNoFeed) {
  EXPECT_TRUE(straight_block(1.0, plain_limits()).is_rapid());
  EXPECT_FALSE(straight_block(1.0, plain_limits(), 0.1F).is_rapid());
}

TEST(BlockBuilder, HasNothingToMoveOnTheSpot) {
  const Position here = place({1.0, 2.0, 3.0});
  const auto none = build_block({.element = {.start = here, .end = here}}, plain_limits());
  EXPECT_EQ(none.error(), MotionError::kNothingToMove);
}

TEST(BlockBuilder, MovesASingleNanometre) {
  for (const float bulge : {0.0F, 1.0F}) {
    PathElement element{.bulge = bulge};
    element.end[0] = Coordinate{1};
    const Block block = block_of(element, plain_limits());
    EXPECT_NEAR(static_cast<double>(block.length), 1.0e-6, 1.0e-6);
    EXPECT_TRUE(std::isfinite(block.speed_limit_square));
  }
}

TEST(BlockBuilder, RefusesWhatTheStepCountersCannotHold) {
  Limits limits = plain_limits();
  limits.scale[1] = AxisScale{100'000.0F};
  const auto far = build_block({.element = {.end = place({0.0, 10'738.0})}}, limits);
  EXPECT_EQ(far.error(), MotionError::kBeyondMotorRange);
}

TEST(BlockBuilder, RefusesAnArcWhoseTurnedChordIsOutOfReach) {
  Limits limits = plain_limits();
  limits.scale[1] = AxisScale{100'000.0F};
  const auto far = build_block({.element = {.end = place({20'000.0}), .bulge = 0.1F}}, limits);
  EXPECT_EQ(far.error(), MotionError::kBeyondMotorRange);
}

TEST(BlockBuilder, RefusesMoreThanHalfATurn) {
  const auto most = build_block({.element = {.end = place({1.0}), .bulge = 1.1F}}, plain_limits());
  EXPECT_EQ(most.error(), MotionError::kBulgeTooLarge);
}

TEST(BlockBuilder, TakesAnArcWithoutAChordForALine) {
  const Block block = block_of({.end = place({0.0, 0.0, 3.0}), .bulge = 0.5F}, plain_limits());
  EXPECT_FALSE(block.turns());
  EXPECT_FLOAT_EQ(block.length, 3.0F);
}

class RandomBlocks : public testing::Test {
 protected:
  void SetUp() override {
    element = any_element_in_space(random, Position{});
    limits = any_limits(random);
  }

  proof::Random random{proof::test_seed()};
  PathElement element;
  Limits limits;
};

TEST_F(RandomBlocks, HaveTheirExactLengthAndTangents) {
  for (int trial = 0; trial < 50'000; ++trial, SetUp()) {
    const Block block = block_of(element, limits);
    const ExactMotion exact{element};
    ASSERT_NEAR(static_cast<double>(block.length) / exact.length(), 1.0, 1.5e-6) << trial;
    const AxisArray<float> entry = entry_tangent(block);
    const AxisArray<float> exit = exit_tangent(block);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      ASSERT_NEAR(static_cast<double>(entry[axis]), exact.tangent_at(0.0)[axis], 2.0e-6) << trial;
      ASSERT_NEAR(static_cast<double>(exit[axis]), exact.tangent_at(1.0)[axis], 2.0e-6) << trial;
    }
  }
}

TEST_F(RandomBlocks, KeepTheRatesOfEveryMotorAndOfAllTogether) {
  for (int trial = 0; trial < 10'000; ++trial, SetUp()) {
    const Block block = block_of(element, limits);
    const ExactMotion exact{element};
    const double speed = std::sqrt(static_cast<double>(block.speed_limit_square));
    for (int part = 0; part <= 8; ++part) {
      const AxisArray<double> tangent = exact.tangent_at(part / 8.0);
      double all_steps = 0.0;
      for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const double rate = speed * std::abs(tangent[axis]);
        all_steps += rate * static_cast<double>(limits.scale[axis].steps_per_mm());
        // Limits of these axes are computed for the spans.
        if (block.turns() && exact.plane().has(axis)) continue;
        ASSERT_LE(rate, static_cast<double>(motor_rate(limits, axis)) * 1.00001) << trial;
      }
      ASSERT_LE(all_steps, static_cast<double>(limits.steps_per_s_all_motors) * 1.00001) << trial;
    }
  }
}

// A bulge is legal from 0 on: an arc that is nearly a line must keep its limits.
TEST(BlockBuilder, KeepsTheLimitsOfAnArcThatIsAlmostALine) {
  const Limits limits = plain_limits();
  for (const float bulge : {1.0e-10F,
                            1.0e-20F,
                            std::numeric_limits<float>::min(),
                            std::numeric_limits<float>::denorm_min()}) {
    const Block block = block_of({.end = place({50.0}), .bulge = bulge}, limits);
    const Spans spans{block, limits};
    const Place from = spans.place_at_boundary(0);
    const Place to = spans.place_at_boundary(1);
    EXPECT_LE(
        spans.steepest(0, from, to, {50.0F, 0.0F, 1.0e12F, Travel::kForward, Change::kSpeedUp}),
        501.0F)
        << "bulge " << bulge;
    EXPECT_LE(spans.speed_limit_square(0), 200.0F * 200.0F * 1.001F) << "bulge " << bulge;
  }
}

}  // namespace
}  // namespace cnc::motion

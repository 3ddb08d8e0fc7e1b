#include "planner/motion/lookahead/time_window.hpp"

#include <gtest/gtest.h>

#include "planner/motion/block/path_units.hpp"
#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

Limits with_jerk(float x, float y) {
  Limits limits = plain_limits();
  limits.jerk_mm_s3[0] = x;
  limits.jerk_mm_s3[1] = y;
  return limits;
}

constexpr std::uint8_t kX = 1;
constexpr std::uint8_t kXy = 3;

TEST(TimeWindow, IsNoneWithoutAJerkLimit) {
  EXPECT_FALSE(window_for(plain_limits(), kXy).filters());
  EXPECT_FALSE(window_for(with_jerk(1.0e9F, 1.0e9F), kXy).filters());
}

TEST(TimeWindow, IsTheLongestRiseOfTheAxesThatMove) {
  const Limits limits = with_jerk(25'000.0F, 10'000.0F);
  EXPECT_NEAR(static_cast<double>(window_for(limits, kX).seconds()), 0.02, 1.0e-6);
  EXPECT_NEAR(static_cast<double>(window_for(limits, kXy).seconds()), 0.05, 1.0e-6);
  EXPECT_LE(window_for(limits, kXy).cell_seconds(), 1.001e-3F);
}

TEST(TimeWindow, HasABoundAndLessAccelerationBeyondIt) {
  const Limits limits = with_jerk(1'000.0F, 0.0F);
  const TimeWindow window = window_for(limits, kX);
  EXPECT_EQ(window.cells, TimeWindow::kMaxCells);
  EXPECT_NEAR(static_cast<double>(window.seconds()), 0.256, 1.0e-4);
  EXPECT_NEAR(static_cast<double>(planned_acceleration(limits, 0, window)), 256.0, 0.1);
  EXPECT_EQ(planned_acceleration(limits, 1, window), 500.0F);
}

/// Returns the window that is chosen for one straight move along X with 500 mm/s² and 25,000 mm/s³.
double chosen(float length, float speed) {
  const Limits limits = with_jerk(25'000.0F, 25'000.0F);
  const Block block = straight_block(length, limits);
  WindowChoice choice{limits};
  choice.add(block, block.length, speed * speed);
  return static_cast<double>(choice.window().seconds());
}

TEST(WindowChoice, IsTheRiseWhereFullAccelerationIsReached) {
  EXPECT_NEAR(chosen(10.0F, 100.0F), 0.02, 1.0e-6);
}

TEST(WindowChoice, IsAsLongAsTheRampOfAShortMove) {
  // 2 J T³ = 0.05 mm.
  EXPECT_NEAR(chosen(0.05F, 100.0F), 0.01, 1.0e-6);
}

TEST(WindowChoice, IsAsLongAsTheRampToALowSpeed) {
  // J T² = 2.5 mm/s.
  EXPECT_NEAR(chosen(10.0F, 2.5F), 0.01, 1.0e-6);
}

TEST(WindowChoice, CanBeAShareOfThat) {
  const Limits limits = with_jerk(25'000.0F, 25'000.0F);
  const Block block = straight_block(10.0F, limits);
  WindowChoice choice{limits};
  choice.add(block, block.length, 1.0e4F);
  EXPECT_NEAR(static_cast<double>(choice.window(0.5F).seconds()), 0.01, 1.0e-6);
  EXPECT_NEAR(static_cast<double>(choice.window(0.01F).seconds()), 1.0e-3, 1.0e-6);
}

TEST(WindowChoice, HasALeastLength) {
  EXPECT_GE(chosen(1.0e-6F, 100.0F), 1.0e-3);
  EXPECT_FALSE(WindowChoice{plain_limits()}.window().filters());
}

TEST(WindowChoice, IsTheLongestThatABlockOfTheChainAsksFor) {
  const Limits limits = with_jerk(25'000.0F, 25'000.0F);
  const Block block = straight_block(10.0F, limits);
  WindowChoice choice{limits};
  choice.add(block, block.length, 1.0F);
  choice.add(block, block.length, 1.0e4F);
  EXPECT_NEAR(static_cast<double>(choice.window().seconds()), 0.02, 1.0e-6);
}

TEST(BlockFraction, IsExactAtTheEndsAndInOrder) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 20'000; ++trial) {
    const auto length = static_cast<PathUnits>(random.magnitude(1.0, 1.0e17));
    BlockFraction fraction{length};
    ASSERT_EQ(fraction.of(0), 0U);
    ASSERT_EQ(fraction.of(length), BlockFraction::kEnd);
    const auto place = static_cast<PathUnits>(static_cast<double>(length) * random.unit());
    const double exact = static_cast<double>(place) / static_cast<double>(length) * 0x1p32;
    ASSERT_NEAR(static_cast<double>(fraction.of(place)), exact, 4.0) << length;
    ASSERT_LE(fraction.of(place), fraction.of(place + (place < length ? 1 : 0)));
  }
}

}  // namespace
}  // namespace cnc::motion

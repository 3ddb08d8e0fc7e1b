#include "planner/motion/segment/stretch_in_progress.hpp"

#include <gtest/gtest.h>

namespace cnc::motion {
namespace {

/// 1000 units in a millisecond, at a constant speed.
constexpr Stretch kEven{
    .way = 1000, .duration_ns = 1'000'000, .start_speed = 2.0F, .end_speed = 2.0F};

TEST(StretchInProgress, IsOverBeforeTheFirstBegins) {
  const StretchInProgress none;
  EXPECT_TRUE(none.is_over(0));
}

TEST(StretchInProgress, IsOverWhenItsTimeAndItsWayAre) {
  StretchInProgress stretch;
  stretch.begin(kEven, 50);
  EXPECT_FALSE(stretch.is_over(50));
  stretch.pass_until(1'000'000);
  EXPECT_FALSE(stretch.is_over(1049));
  EXPECT_TRUE(stretch.is_over(1050));
}

TEST(StretchInProgress, CountsPlacesFromTheFrontBlock) {
  StretchInProgress stretch;
  stretch.begin(kEven, 50);
  EXPECT_EQ(stretch.place_after(1'000'000), 1050);
  stretch.leave_block(400);
  EXPECT_EQ(stretch.place_after(1'000'000), 650);
}

TEST(StretchInProgress, KnowsTheTimeThatIsLeftAndTheTimeOfAWay) {
  StretchInProgress stretch;
  stretch.begin(kEven, 0);
  stretch.pass_until(250'000);
  EXPECT_EQ(stretch.left_ns(), 750'000U);
  EXPECT_NEAR(static_cast<double>(stretch.time_after(500)), 750'000.0, 1.0);
  stretch.end_at(700);
  EXPECT_EQ(stretch.left_ns(), 0U);
  EXPECT_TRUE(stretch.is_over(700));
}

}  // namespace
}  // namespace cnc::motion

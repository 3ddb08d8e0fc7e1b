#include "planner/motion/segment/stretch_in_progress.hpp"

#include <gtest/gtest.h>

namespace cnc::motion {
namespace {

/// Two micrometres in a millisecond, at a constant speed.
constexpr auto kWay = static_cast<PathUnits>(0.002F * kUnitsPerMm);
constexpr Stretch kEven{
    .way = kWay, .duration_ns = 1'000'000, .start_speed = 2.0F, .end_speed = 2.0F};

TEST(StretchInProgress, IsOverBeforeTheFirstBegins) {
  const StretchInProgress none;
  EXPECT_TRUE(none.is_over(0));
}

TEST(StretchInProgress, IsOverWhenItsTimeAndItsWayAre) {
  StretchInProgress stretch;
  stretch.begin(kEven, 50);
  EXPECT_FALSE(stretch.is_over(50));
  stretch.pass_until(1'000'000);
  EXPECT_FALSE(stretch.is_over(49 + kWay));
  EXPECT_TRUE(stretch.is_over(50 + kWay));
}

TEST(StretchInProgress, CountsPlacesFromTheFrontBlock) {
  StretchInProgress stretch;
  stretch.begin(kEven, 50);
  EXPECT_EQ(stretch.place_after(1'000'000), 50 + kWay);
  stretch.leave_block(400);
  EXPECT_EQ(stretch.place_after(1'000'000), kWay - 350);
}

TEST(StretchInProgress, KnowsTheTimeThatIsLeftAndTheTimeOfAWay) {
  StretchInProgress stretch;
  stretch.begin(kEven, 0);
  stretch.pass_until(250'000);
  EXPECT_EQ(stretch.left_ns(), 750'000U);
  EXPECT_NEAR(static_cast<double>(stretch.time_after(kWay / 2)), 750'000.0, 2.0);
  stretch.end_at(kWay / 2);
  EXPECT_EQ(stretch.left_ns(), 0U);
  EXPECT_TRUE(stretch.is_over(kWay / 2));
}

}  // namespace
}  // namespace cnc::motion

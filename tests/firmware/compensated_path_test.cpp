#include "firmware/machine/compensated_path.hpp"

#include <gtest/gtest.h>

#include "planner/kerf/csp_1n.hpp"

namespace cnc {
namespace {

using gcode::CutterSide;

/// G41 or G42 with a cut 2 mm wide, in the plane of X and Y.
class CompensatedPathTest : public testing::Test {
 protected:
  static Position at(float x, float y, float z = 0.0F) {
    return {from_mm(x), from_mm(y), from_mm(z)};
  }
  void set(CutterSide side, bool by_kerf = false) {
    path_.set({.side = side, .by_kerf = by_kerf, .width_mm = 2.0F}, Plane::kXY);
  }
  /// Passes a line on from where the last one ended, if the entry has begun.
  void drive(const Position& end) {
    const PathElement element{.start = here_, .end = end};
    ASSERT_TRUE(path_.begin_with(element));
    ASSERT_FALSE(path_.put({.request = {.element = element, .feed_mm_s = 10.0F}}));
    here_ = end;
    give_out();
  }
  void give_out() {
    for (path::PathItem item; path_.take(item);) driven_ = item.request.element.end;
  }
  /// Cuts along X and ends the path at (30, 10).
  void cut_along_x(CutterSide side) {
    set(side);
    drive(at(0.0F, 10.0F));
    drive(at(30.0F, 10.0F));
    path_.cancel();
    ASSERT_FALSE(path_.end());
    give_out();
  }

  CompensatedPath path_;
  Position here_{};
  Position driven_{};
};

TEST_F(CompensatedPathTest, IsTheProgrammedOneWithoutG41) {
  EXPECT_FALSE(path_.compensates());
  EXPECT_TRUE(path_.begin_with({.end = at(1.0F, 0.0F)}));
  EXPECT_FALSE(path_.active());
}

TEST_F(CompensatedPathTest, BeginsWithTheFirstMotionInThePlane) {
  set(CutterSide::kLeft);
  EXPECT_TRUE(path_.compensates());
  EXPECT_FALSE(path_.begin_with({.end = at(0.0F, 0.0F, 5.0F)}));
  EXPECT_FALSE(path_.active());
  EXPECT_TRUE(path_.begin_with({.end = at(0.0F, 10.0F)}));
  EXPECT_TRUE(path_.active());
}

TEST_F(CompensatedPathTest, IsOffsetToTheSideByHalfTheWidth) {
  cut_along_x(CutterSide::kLeft);
  EXPECT_NEAR(driven_[1].mm(), 11.0F, 1.0e-5F);
  EXPECT_NEAR(driven_[0].mm(), 30.0F, 1.0e-5F);
}

TEST_F(CompensatedPathTest, IsOffsetToTheRightUnderG42) {
  cut_along_x(CutterSide::kRight);
  EXPECT_NEAR(driven_[1].mm(), 9.0F, 1.0e-5F);
}

TEST_F(CompensatedPathTest, StaysBesideUntilAMotionInThePlane) {
  cut_along_x(CutterSide::kLeft);
  EXPECT_FALSE(path_.compensates());
  ASSERT_TRUE(path_.beside());
  EXPECT_TRUE(path_.stays_beside(at(30.0F, 10.0F, 5.0F)));
  EXPECT_FALSE(path_.stays_beside(at(40.0F, 10.0F)));
  EXPECT_FALSE(path_.stays_beside(at(30.0F, 10.0F))) << "an exit of no length";
}

TEST_F(CompensatedPathTest, MovesOtherAxesWhereItIsBeside) {
  cut_along_x(CutterSide::kLeft);
  PathElement lift{.start = at(30.0F, 10.0F), .end = at(30.0F, 10.0F, 5.0F)};
  path_.move_apart(lift);
  EXPECT_EQ(lift.start[1], driven_[1]);
  EXPECT_EQ(lift.end[1], driven_[1]);
  EXPECT_EQ(lift.end[2], from_mm(5.0F));
  EXPECT_EQ(path_.programmed(), at(30.0F, 10.0F, 5.0F));
}

TEST_F(CompensatedPathTest, LeavesMotionsAloneOnThePath) {
  PathElement line{.end = at(3.0F, 4.0F)};
  path_.move_apart(line);
  EXPECT_EQ(line.end, at(3.0F, 4.0F));
  EXPECT_EQ(path_.programmed(), at(3.0F, 4.0F));
}

TEST_F(CompensatedPathTest, KeepsTheKerfUntilTheExitIsDriven) {
  set(CutterSide::kLeft, true);
  path_.cancel();
  EXPECT_FALSE(path_.compensates());
  EXPECT_TRUE(path_.by_kerf());
  path_.end_exit();
  EXPECT_FALSE(path_.by_kerf());
}

TEST_F(CompensatedPathTest, ForgetsAllButTheKerfTable) {
  path_.use_kerf({.count = 3, .index = 2, .view = kerf::kCsp1nPhysical<float>});
  cut_along_x(CutterSide::kLeft);
  set(CutterSide::kLeft, true);
  path_.reset();
  EXPECT_FALSE(path_.compensates());
  EXPECT_FALSE(path_.beside());
  EXPECT_FALSE(path_.by_kerf());
  EXPECT_TRUE(path_.kerf().holds(2));
}

TEST_F(CompensatedPathTest, FollowsTheKerfOfItsTable) {
  path_.use_kerf({.count = 1, .view = kerf::kCsp1nPhysical<float>});
  const kerf::KerfCourse& course = path_.course_from({2000, 1'800'000, 4'000'000});
  EXPECT_FLOAT_EQ(course.speed_mm_s(), 4000.0F / 60.0F);
  EXPECT_GT(course.aside_mm(2.0F), 0.02F);
}

}  // namespace
}  // namespace cnc

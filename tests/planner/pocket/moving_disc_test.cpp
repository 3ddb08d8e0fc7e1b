#include "planner/pocket/moving_disc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace cnc::pocket {
namespace {

/// Tests a slot of 20 × 10 mm whose lower side has a corner that points into it at (10, 2).
class MovingDiscTest : public ::testing::Test {
 protected:
  MovingDiscTest() {
    const std::vector<contour::Vertex<double>> vertices{
        {0, 0, 0}, {8, 0, 0}, {10, 2, 0}, {12, 0, 0}, {20, 0, 0}, {20, 10, 0}, {0, 10, 0}};
    const std::vector<std::uint32_t> loop_ends{7};
    EXPECT_TRUE(area_.read({{vertices.data(), 7}, {loop_ends.data(), 1}}));
  }

  BoundedDistanceSpace<8, 1> space_;
  AreaDistance area_{space_.space()};
};

TEST_F(MovingDiscTest, HasNoExcessWhereItFits) {
  EXPECT_EQ(excess_of({{5, 5}, {5, 8}, 5.0, 2.0}, area_), 0.0);
  EXPECT_NEAR(excess_of({{4, 6}, {16, 6}, 4.0, 4.0}, area_), 0.0, 1e-15);
}

TEST_F(MovingDiscTest, FindsACornerBetweenTheEnds) {
  // The disc fits at both ends.
  EXPECT_NEAR(excess_of({{2.5, 6}, {17.5, 6}, 2.5, 2.5}, area_), 0.0, 1e-15);
  EXPECT_NEAR(excess_of({{5, 5}, {15, 5}, 4.5, 4.5}, area_), 1.5, 1e-15);
}

TEST_F(MovingDiscTest, FindsWhereAGrowingDiscReachesFarthest) {
  const MovingDisc disc{{4, 5}, {15, 5}, 1.0, 5.0};
  double greatest = 0.0;
  for (int i = 0; i <= 100000; ++i) {
    const double share = i / 100000.0;
    const WideVec2 place = disc.from + share * (disc.to - disc.from);
    const double radius = disc.from_radius + share * (disc.to_radius - disc.from_radius);
    greatest = std::max(greatest, radius - area_.depth(place));
  }
  ASSERT_GT(greatest, 0.3);
  EXPECT_NEAR(excess_of(disc, area_), greatest, 1e-9);
}

TEST_F(MovingDiscTest, MeasuresADiscThatStays) {
  EXPECT_NEAR(excess_of({{10, 5}, {10, 5}, 3.25, 3.25}, area_), 0.25, 1e-15);
}

}  // namespace
}  // namespace cnc::pocket

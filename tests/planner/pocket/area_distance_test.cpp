#include "planner/pocket/area_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace cnc::pocket {
namespace {

using contour::Vertex;

/// An area of up to 16 elements.
class AreaDistanceTest : public ::testing::Test {
 protected:
  void add(double x, double y, double bulge = 0.0) { vertices_.push_back({x, y, bulge}); }
  void close() { loop_ends_.push_back(static_cast<std::uint32_t>(vertices_.size())); }
  bool read() {
    return area_.read(
        {{vertices_.data(), vertices_.size()}, {loop_ends_.data(), loop_ends_.size()}});
  }
  void rectangle(double x0, double y0, double x1, double y1) {
    add(x0, y0);
    add(x1, y0);
    add(x1, y1);
    add(x0, y1);
    close();
  }

  std::vector<Vertex<double>> vertices_;
  std::vector<std::uint32_t> loop_ends_;
  BoundedDistanceSpace<16, 2> space_;
  AreaDistance area_{space_.space()};
};

TEST_F(AreaDistanceTest, MeasuresFromTheSidesAndCornersOfASquare) {
  rectangle(0, 0, 10, 10);
  ASSERT_TRUE(read());
  EXPECT_EQ(area_.depth({4, 3}), 3.0);
  EXPECT_EQ(area_.depth({12, 5}), -2.0);
  EXPECT_EQ(area_.depth({13, 14}), -5.0);
  const BoundaryPoint corner = area_.nearest({13, 14});
  EXPECT_EQ(corner.point, WideVec2(10, 10));
  const BoundaryPoint side = area_.nearest({4, 3});
  EXPECT_EQ(side.point, WideVec2(4, 0));
  EXPECT_EQ(side.element, 0U);
}

TEST_F(AreaDistanceTest, KnowsThatAPlaceBeforeACornerOfAHoleIsInside) {
  rectangle(0, 0, 10, 10);
  add(4, 4);
  add(4, 6);
  add(6, 6);
  add(6, 4);
  close();
  ASSERT_TRUE(read());
  EXPECT_NEAR(area_.depth({3, 3}), std::sqrt(2.0), 1e-15);
  EXPECT_EQ(area_.depth({5, 5}), -1.0);
  EXPECT_EQ(area_.next(3), 0U);
  EXPECT_EQ(area_.next(7), 4U);
  EXPECT_EQ(area_.previous(4), 7U);
}

TEST_F(AreaDistanceTest, MeasuresACircleFromInsideAndOutside) {
  add(5, 0, 1.0);
  add(-5, 0, 1.0);
  close();
  ASSERT_TRUE(read());
  EXPECT_EQ(area_.depth({0, 0}), 5.0);
  EXPECT_NEAR(area_.depth({-3, 0}), 2.0, 1e-15);
  EXPECT_NEAR(area_.depth({3, 4.0 + 3.0}), 5.0 - std::sqrt(58.0), 1e-14);
  EXPECT_NEAR(area_.nearest({0.3, 0.4}).point.x(), 3.0, 1e-14);
  EXPECT_NEAR(area_.nearest({0.3, 0.4}).point.y(), 4.0, 1e-14);
}

TEST_F(AreaDistanceTest, SplitsAnArcOfMoreThanHalfATurn) {
  const double angle = 2.0 * std::acos(-1.0) - 2.0 * std::atan2(4.0, 3.0);
  add(3, 4, std::tan(angle / 4.0));
  add(3, -4);
  close();
  ASSERT_TRUE(read());
  EXPECT_EQ(area_.element_count(), 3U);
  EXPECT_NEAR(area_.depth({-4, 0}), 1.0, 1e-14);
  EXPECT_NEAR(area_.depth({0, 0}), 3.0, 1e-14);
  EXPECT_NEAR(area_.depth({4, 0}), -1.0, 1e-14);
}

TEST_F(AreaDistanceTest, TellsTheInsideOfACuspFromTheOutside) {
  // The area is a crescent whose circles touch at (5, 0).
  add(5, 0, 1.0);
  add(-5, 0, 1.0);
  add(5, 0, -1.0);
  add(-1, 0, -1.0);
  close();
  ASSERT_TRUE(read());
  EXPECT_NEAR(area_.depth({-3, 0}), 2.0, 1e-14);
  EXPECT_NEAR(area_.depth({2, 0}), -3.0, 1e-14);
  EXPECT_NEAR(area_.depth({5.5, 0}), -0.5, 1e-14);
  EXPECT_LT(area_.depth({4.5, 0}), 0.0);
}

TEST_F(AreaDistanceTest, TellsTheOutsideOfACuspFromTheInside) {
  rectangle(-10, -10, 10, 10);
  add(5, 0, 1.0);
  add(-1, 0, 1.0);
  add(5, 0, -1.0);
  add(-5, 0, -1.0);
  close();
  ASSERT_TRUE(read());
  EXPECT_NEAR(area_.depth({-3, 0}), -2.0, 1e-14);
  EXPECT_NEAR(area_.depth({2, 0}), 3.0, 1e-14);
  EXPECT_NEAR(area_.depth({5.5, 0}), 0.5, 1e-14);
  EXPECT_NEAR(area_.depth({4.5, 0}), 0.5, 1e-14);
}

TEST_F(AreaDistanceTest, ForgetsElementsWithoutLength) {
  add(0, 0);
  add(0, 0);
  add(10, 0);
  add(10, 10);
  add(10, 12);
  add(10, 10);
  add(0, 10);
  close();
  ASSERT_TRUE(read());
  EXPECT_EQ(area_.element_count(), 4U);
  EXPECT_EQ(area_.depth({9.5, 5}), 0.5);
}

TEST_F(AreaDistanceTest, RefusesWhatIsNoNumberOrTooMuch) {
  rectangle(0, 0, std::numeric_limits<double>::infinity(), 10);
  EXPECT_FALSE(read());
  vertices_.clear();
  for (int i = 0; i < 40; ++i) add(10.0 * std::cos(0.15 * i), 10.0 * std::sin(0.15 * i));
  loop_ends_ = {40};
  EXPECT_FALSE(read());
  vertices_.clear();
  loop_ends_.clear();
  rectangle(0, 0, 1, 1);
  rectangle(2, 0, 3, 1);
  rectangle(4, 0, 5, 1);
  EXPECT_FALSE(read());
}

}  // namespace
}  // namespace cnc::pocket

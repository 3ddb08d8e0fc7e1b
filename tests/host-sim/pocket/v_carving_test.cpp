#include "host-sim/pocket/v_carving.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "host-sim/contour/contour_text.hpp"

namespace sim::pocket {
namespace {

using cnc::pocket::Use;

constexpr double kDepth_mm = 0.01;

VCarving carved(std::string_view text, const VCarveOptions& options = {}) {
  const Contour area = contour_from_text(text, "test");
  return v_carve(area.view(), options);
}

constexpr std::string_view kSquare = "0 0\n10 0\n10 10\n0 10\nclosed\n";

/// Returns the depth that the tool cuts at a point, if it is a point of the path.
double depth_at(const VCarving& carving, double x, double y) {
  double depth = -1.0;
  for (const auto& point : carving.points) {
    if (std::hypot(point.x - x, point.y - y) < 0.01) depth = std::max(depth, -point.z);
  }
  return depth;
}

std::size_t count_of(const VCarving& carving, Use use) {
  return static_cast<std::size_t>(
      std::ranges::count_if(carving.points, [use](const auto& point) { return point.use == use; }));
}

TEST(VCarving, CutsASquareAsAPyramid) {
  const VCarving carving = carved(kSquare);
  EXPECT_NEAR(depth_at(carving, 5, 5), 5.0, kDepth_mm);
  for (const double x : {0.0, 10.0}) {
    for (const double y : {0.0, 10.0}) EXPECT_NEAR(depth_at(carving, x, y), 0.0, 1.0e-6);
  }
  EXPECT_EQ(carving.row_ends.size(), 1U);
  EXPECT_NEAR(carving.depth_mm, 5.0, kDepth_mm);
  EXPECT_TRUE(carving.wide.vertices.empty());
}

TEST(VCarving, IsDeeperWithASteeperTool) {
  const VCarving carving = carved(kSquare, {.included_angle_deg = 60.0});
  EXPECT_NEAR(depth_at(carving, 5, 5), 5.0 * std::sqrt(3.0), kDepth_mm);
}

TEST(VCarving, GoesAroundWhatIsTooWideForTheGreatestDepth) {
  const VCarving carving = carved(kSquare, {.greatest_depth_mm = 2.0});
  EXPECT_NEAR(carving.depth_mm, 2.0, 1.0e-9);
  EXPECT_NEAR(carving.wide_area_mm2, 36.0, 1.0e-6);
  EXPECT_EQ(carving.wide.vertices.size(), 4U);
  EXPECT_EQ(carving.row_ends.size(), 5U);  // The rows are four corners and the loop.
  for (const double x : {2.0, 8.0}) {
    for (const double y : {2.0, 8.0}) EXPECT_NEAR(depth_at(carving, x, y), 2.0, kDepth_mm);
  }
}

TEST(VCarving, KeepsArcsOfThatContour) {
  const VCarving carving = carved("10 0 1\n-10 0 1\nclosed\n", {.greatest_depth_mm = 3.0});
  ASSERT_EQ(carving.row_ends.size(), 1U);
  EXPECT_EQ(carving.points.size(), 4U);
  EXPECT_EQ(carving.points[0].use, Use::kEntry);
  EXPECT_NEAR(std::abs(carving.points[1].bulge), 1.0, 1.0e-9);
  EXPECT_NEAR(carving.wide_area_mm2, 49.0 * std::acos(-1.0), 1.0e-6);
}

TEST(VCarving, GoesDownOnceInACircle) {
  const VCarving carving = carved("10 0 1\n-10 0 1\nclosed\n");
  ASSERT_EQ(carving.points.size(), 2U);
  EXPECT_EQ(carving.points[0].z, 0.0);
  EXPECT_NEAR(carving.points[1].z, -10.0, kDepth_mm);
  EXPECT_NEAR(carving.points[1].x, 0.0, 1.0e-3);
}

TEST(VCarving, HasNoWideAreaWhereTheGreatestDepthJustFits) {
  const VCarving carving = carved("0 0\n20 0\n20 4\n0 4\nclosed\n", {.greatest_depth_mm = 2.0});
  EXPECT_TRUE(carving.wide.vertices.empty());
  EXPECT_NEAR(depth_at(carving, 18, 2), 2.0, kDepth_mm);
}

TEST(VCarving, ReturnsAlongWhatItHasCut) {
  const VCarving carving = carved(kSquare, {.return_limit_mm = 10.0});
  EXPECT_EQ(carving.row_ends.size(), 1U);
  EXPECT_GT(count_of(carving, Use::kLink), 0U);
  const VCarving lifted = carved(kSquare, {.return_limit_mm = 0.0});
  EXPECT_EQ(lifted.row_ends.size(), 2U);  // The rows are two diagonals.
  EXPECT_EQ(count_of(lifted, Use::kLink), 0U);
}

TEST(VCarving, PlungesWhereARowBeginsAtADepth) {
  const VCarving ring = carved("10 0 1\n-10 0 1\nclosed\n3 0 -1\n-3 0 -1\nclosed\n");
  ASSERT_EQ(ring.row_ends.size(), 1U);
  EXPECT_EQ(ring.points[0].use, Use::kEntry);
  EXPECT_EQ(ring.points[0].z, 0.0);
  EXPECT_NEAR(ring.points[1].z, -3.5, kDepth_mm);
  EXPECT_EQ(ring.points[0].x, ring.points[1].x);
}

TEST(VCarving, TakesFewPointsForCurves) {
  const VCarving ring = carved("10 0 1\n-10 0 1\nclosed\n3 0 -1\n-3 0 -1\nclosed\n");
  // With a chord error of a third of 0.005 mm, a circle of 6.5 mm has 2π / (2 √(2 · 0.005 / 3 /
  // 6.5)) = 139 chords.
  EXPECT_GT(ring.points.size(), 100U);
  EXPECT_LT(ring.points.size(), 230U);
}

TEST(VCarving, RefusesOptionsOutOfRange) {
  EXPECT_THROW(carved(kSquare, {.included_angle_deg = 0.0}), std::invalid_argument);
  EXPECT_THROW(carved(kSquare, {.included_angle_deg = 180.0}), std::invalid_argument);
  EXPECT_THROW(carved(kSquare, {.greatest_depth_mm = 0.0}), std::invalid_argument);
  EXPECT_THROW(carved(kSquare, {.greatest_depth_mm = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(carved(kSquare, {.tolerance_mm = 0.0}), std::invalid_argument);
  EXPECT_THROW(carved(kSquare, {.return_limit_mm = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace sim::pocket

#include "host-sim/plot/path_simplifier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/trials.hpp"

namespace sim {
namespace {

using Vertices = std::vector<PathVertex>;

double distance_to_stretch(const PathVertex& p, const PathVertex& a, const PathVertex& b) {
  const double way_x = b.x_mm - a.x_mm;
  const double way_y = b.y_mm - a.y_mm;
  const double square = way_x * way_x + way_y * way_y;
  const double along = (p.x_mm - a.x_mm) * way_x + (p.y_mm - a.y_mm) * way_y;
  const double f = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x_mm - a.x_mm - f * way_x, p.y_mm - a.y_mm - f * way_y);
}

double distance_to_path(const PathVertex& point, const Vertices& path) {
  double least = std::hypot(point.x_mm - path[0].x_mm, point.y_mm - path[0].y_mm);
  for (std::size_t i = 1; i < path.size(); ++i) {
    least = std::min(least, distance_to_stretch(point, path[i - 1], path[i]));
  }
  return least;
}

/// Returns a random path with smooth curves, corners and reversals.
Vertices random_walk(std::uint64_t seed, double stride_mm) {
  std::mt19937 random{seed};
  std::normal_distribution<double> turn{0.0, 0.15};
  std::uniform_real_distribution<double> any{-3.14, 3.14};
  Vertices points{{.move = Move::kCut}};
  double heading = 0.0;
  for (int i = 0; i < 1'000; ++i) {
    heading += i % 40 == 0 ? any(random) : turn(random);
    const PathVertex& last = points.back();
    points.push_back({last.x_mm + stride_mm * std::cos(heading),
                      last.y_mm + stride_mm * std::sin(heading),
                      10.0F,
                      Move::kCut});
  }
  return points;
}

TEST(PathSimplifier, MakesALineOfTwoVertices) {
  Vertices points;
  for (int i = 0; i <= 1'000; ++i) points.push_back({0.3 * i, 0.1 * i, 5.0F, Move::kCut});
  const Vertices line = simplified(points, {.distance_mm = 0.01});
  ASSERT_EQ(line.size(), 2U);
  EXPECT_EQ(line[1].x_mm, 300.0);
  EXPECT_EQ(line[1].speed_mm_s, 5.0F);
}

TEST(PathSimplifier, KeepsCornersAndReversals) {
  Vertices points;
  for (int i = 0; i <= 100; ++i) points.push_back({0.1 * i, 0.0});
  for (int i = 0; i <= 100; ++i) points.push_back({10.0, 0.1 * i});
  for (int i = 100; i >= 50; --i) points.push_back({10.0, 0.1 * i});
  const Vertices path = simplified(points, {.distance_mm = 0.01});
  ASSERT_EQ(path.size(), 4U);
  EXPECT_NEAR(path[1].x_mm, 10.0, 1e-9);
  EXPECT_NEAR(path[2].y_mm, 10.0, 1e-9);
}

TEST(PathSimplifier, KeepsEveryChangeOfMove) {
  Vertices points;
  for (int i = 0; i <= 100; ++i) {
    points.push_back({1.0 * i, 0.0, 1.0F, i > 50 ? Move::kCut : Move::kTravel});
  }
  const Vertices path = simplified(points, {.distance_mm = 0.01});
  ASSERT_EQ(path.size(), 3U);
  EXPECT_EQ(path[1].x_mm, 50.0);
  EXPECT_EQ(path[1].move, Move::kTravel);
  EXPECT_EQ(path[2].move, Move::kCut);
}

TEST(PathSimplifier, FollowsTheSpeed) {
  Vertices points;
  for (int i = 0; i <= 1'000; ++i) {
    points.push_back({0.1 * i, 0.0, 0.1F * static_cast<float>(i), Move::kCut});
  }
  const Vertices path = simplified(points, {.distance_mm = 0.01, .speed_mm_s = 5.0F});
  EXPECT_NEAR(static_cast<double>(path.size()), 20.0, 2.0);
  for (const PathVertex& vertex : path) EXPECT_NEAR(vertex.speed_mm_s, vertex.x_mm, 5.01);
}

// Property: the bound in the header holds for paths with steps from far below to far above the
// tolerance.
TEST(PathSimplifier, StaysWithinTheTolerance) {
  constexpr double kToleranceMm = 0.01;
  for (const std::uint64_t seed : proof::Trials{60}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const double stride_mm = 1e-4 * std::pow(1.12, static_cast<double>(1 + seed % 60));
    const Vertices points = random_walk(seed, stride_mm);
    const Vertices path = simplified(points, {.distance_mm = kToleranceMm});
    for (const PathVertex& point : points) {
      ASSERT_LE(distance_to_path(point, path), kToleranceMm);
    }
    EXPECT_EQ(path.back().x_mm, points.back().x_mm);
  }
}

TEST(PathSimplifier, TakesPointsThatNeverMove) {
  EXPECT_EQ(simplified({}, {}).size(), 0U);
  EXPECT_EQ(simplified({{}}, {}).size(), 1U);
  EXPECT_EQ(simplified(Vertices(100), {.distance_mm = 0.0}).size(), 2U);
}

}  // namespace
}  // namespace sim

#include "host-sim/surface/path/region/milled_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <vector>

#include "host-sim/surface/path/part_queue.hpp"
#include "host-sim/surface/path/region/drawn_region.hpp"
#include "host-sim/surface/path/region/slope_region.hpp"
#include "planner/pocket/loop_measures.hpp"
#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/host-sim/surface/slice_parts.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;

bool is_in_order(const SliceParts& parts, double begin, double end) {
  double from = begin;
  for (const auto& [part_begin, part_end] : parts) {
    if (part_begin < from || part_end <= part_begin || part_end > end) return false;
    from = part_end;
  }
  return true;
}

Slice random_slice(proof::Random& random, double reach_mm) {
  const Vector2d from{random.between(-reach_mm, reach_mm), random.between(-reach_mm, reach_mm)};
  const double angle = random.chance(0.5)
                           ? 0.5 * std::numbers::pi * static_cast<double>(random.below(4))
                           : random.between(-4.0, 4.0);
  return {.from = from,
          .direction = Vector2d{std::cos(angle), std::sin(angle)},
          .length = random.between(1.0, 3.0 * reach_mm)};
}

/// Returns whether an odd number of loops encloses a point.
bool is_inside(const Contour& contour, const Vector2d& place) {
  int loops = 0;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    if (cnc::pocket::turns_around(contour.view(), loop, cnc::WideVec2{place}) != 0) ++loops;
  }
  return loops % 2 == 1;
}

/// Returns a star of lines and flat arcs, sometimes with an island of one circle; its loops do not
/// cross.
Contour random_star_with_island(proof::Random& random) {
  Contour contour;
  const std::size_t count = 8 + random.below(8);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const double radius = random.between(25.0, 40.0);
    contour.vertices.push_back({radius * std::cos(angle),
                                radius * std::sin(angle),
                                random.chance(0.5) ? 0.0 : random.between(-0.2, 0.2)});
  }
  contour.end_loop();
  if (random.chance(0.5)) return contour;
  const double radius = random.between(1.0, 12.0);
  const double x = random.between(-4.0, 4.0);
  contour.vertices.push_back({x - radius, 0.0, -1.0});
  contour.vertices.push_back({x + radius, 0.0, -1.0});
  contour.end_loop();
  return contour;
}

TEST(MilledRegion, DrawnContoursHoldThePlacesWithinThem) {
  std::size_t inside = 0;
  for (const std::uint64_t seed : proof::Trials{2'000}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Contour contour = random_star_with_island(random);
    const DrawnRegion region{{contour}};
    const pocket::OwnedArea area{contour.view()};
    const Slice slice = random_slice(random, 40.0);
    const SliceParts parts = region.parts_of(slice, 0.0, slice.length);
    EXPECT_TRUE(is_in_order(parts, 0.0, slice.length));
    for (int i = 0; i < 300; ++i) {
      const double along = slice.length * random.unit();
      const Vector2d place = slice.at(along);
      if (std::abs(area->depth(place)) < 3.0e-6) continue;
      const bool is_in = is_inside(contour, place);
      EXPECT_EQ(has(parts, along), is_in) << place.x() << " " << place.y();
      inside += is_in ? 1U : 0U;
    }
  }
  EXPECT_GT(inside, 0U);
}

TEST(MilledRegion, RowsAlongABoundaryAreInIt) {
  Contour square;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}}) {
    square.vertices.push_back({x, y, 0.0});
  }
  square.end_loop();
  const DrawnRegion region{{square}};
  for (const double y : {0.0, 10.0}) {
    const SliceParts parts = region.parts_of({{-5.0, y}, {1.0, 0.0}, 30.0}, 0.0, 30.0);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_NEAR(parts[0].first, 5.0, 1.0e-9);
    EXPECT_NEAR(parts[0].second, 15.0, 1.0e-9);
  }
  EXPECT_TRUE(region.parts_of({{-5.0, -0.001}, {1.0, 0.0}, 30.0}, 0.0, 30.0).empty());
}

TEST(MilledRegion, TangentsOfABoundaryAreNotInIt) {
  Contour circle;
  circle.vertices = {{16.000000000000004, 10.000000000000002, 0.9999999999999999},
                     {4.0, 10.000000000000002, 0.9999999999999999}};
  circle.end_loop();
  const DrawnRegion region{{circle}};
  for (const double beside : {-1.0e-7, -1.0e-9, 0.0, 1.0e-9, 1.0e-7, 1.0e-5}) {
    const SliceParts parts = region.parts_of({{0.0, 4.0 - beside}, {1.0, 0.0}, 20.0}, 0.0, 20.0);
    double length = 0.0;
    for (const auto& [begin, end] : parts) length += end - begin;
    EXPECT_LT(length, 0.01) << beside;
  }
}

/// Returns a roof of two planes that descend by `fall` from a ridge along Y.
Mesh roof(double fall) {
  Mesh mesh;
  for (const double y : {-20.0, 20.0}) {
    for (const double x : {-20.0, 0.0, 20.0}) mesh.points.emplace_back(x, y, -fall * std::abs(x));
  }
  add_facets(2, 3, mesh);
  return mesh;
}

TEST(MilledRegion, SlopesOfARoofEndWhereTheBallLeavesItsRidge) {
  const double radius = 2.0;
  const cnc::surface::Profile ball{.radius_mm = radius, .flat_mm = 0.0, .corner_mm = radius};
  constexpr double kDegree = std::numbers::pi / 180.0;
  const Mesh mesh = roof(1.0);
  const Slice slice{{-15.0, 1.0}, {1.0, 0.0}, 30.0};
  // On the ridge the slope is that of the ball at the point where the ridge touches it: x = r
  // sin(slope).
  for (const double low : {10.0, 20.0, 35.0}) {
    const double border = radius * std::sin(low * kDegree);
    const SlopeRegion steep{mesh, ball, {}, {low * kDegree, 90.0 * kDegree}};
    const SlopeRegion shallow{mesh, ball, {}, {0.0, low * kDegree}};
    const SliceParts steep_parts = steep.parts_of(slice, 0.0, slice.length);
    const SliceParts shallow_parts = shallow.parts_of(slice, 0.0, slice.length);
    // A gap of less than twice the overlap disappears.
    if (border > 2.0 * 0.125 * radius) {
      ASSERT_EQ(steep_parts.size(), 2U);
      EXPECT_NEAR(steep_parts[0].second, 15.0 - border + 0.125 * radius, 1.0e-5);
      EXPECT_NEAR(steep_parts[1].first, 15.0 + border - 0.125 * radius, 1.0e-5);
    }
    ASSERT_EQ(shallow_parts.size(), 1U);
    EXPECT_NEAR(shallow_parts[0].first, 15.0 - border - 0.125 * radius, 1.0e-5);
    EXPECT_NEAR(shallow_parts[0].second, 15.0 + border + 0.125 * radius, 1.0e-5);
  }
}

/// Returns the length of the stretch around a point of a slice in which the slope stays on one side
/// of the limit. The stretch ends at `most` on each side. The result is too long by at most
/// 2 percent of `most`.
template <typename Function>
double length_of_stretch(const Function& is_steep, double along, double most) {
  constexpr int kSteps = 100;
  const bool wanted = is_steep(along);
  int same = 0;
  for (const int side : {-1, 1}) {
    int step = 1;
    while (step <= kSteps && is_steep(along + side * step * most / kSteps) == wanted) ++step;
    same += step;
  }
  return same * most / kSteps;
}

/// Each point has a slope in one of two ranges with a common limit. The points of a range must be
/// in its region.
TEST(MilledRegion, SlopesOfHillsAreInTheRangeOrNearIt) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Mesh mesh = random_waves(random, 14, 1.0);
    const double radius = random.magnitude(0.3, 3.0);
    const cnc::surface::Profile ball{.radius_mm = radius, .flat_mm = 0.0, .corner_mm = radius};
    const double limit = random.between(0.05, 0.7);
    const SlopeRegion steep{mesh, ball, {}, {limit, 1.6}};
    const SlopeRegion shallow{mesh, ball, {}, {0.0, limit}};
    const ToolHeights heights{mesh, ball, {}};
    const Slice slice{{0.0, random.between(0.5, 12.5)}, {1.0, 0.0}, 13.0};
    const SliceParts in_steep = steep.parts_of(slice, 0.0, slice.length);
    const SliceParts in_shallow = shallow.parts_of(slice, 0.0, slice.length);
    EXPECT_TRUE(is_in_order(in_steep, 0.0, slice.length));
    const auto is_steep = [&](double along) {
      const auto rise = heights.rise(slice.at(along));
      return rise && std::atan(rise->norm()) >= limit;
    };
    for (int i = 0; i < 200; ++i) {
      const double along = random.between(0.0, slice.length);
      EXPECT_TRUE(has(in_steep, along) || has(in_shallow, along));
      if (has(is_steep(along) ? in_steep : in_shallow, along)) continue;
      // A stretch between two samples, an eighth of the radius apart, may be missed.
      EXPECT_LT(length_of_stretch(is_steep, along, 0.125 * radius), 0.13 * radius) << along;
    }
  }
}

TEST(PartQueue, TakesTheNearestPartEachTimeAndAllOfThem) {
  for (const std::uint64_t seed : proof::Trials{500}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    std::vector<RowPart> parts;
    for (std::size_t i = random.below(60); i > 0; --i) {
      const double begin = random.between(0.0, 20.0);
      const double row =
          random.chance(0.5) ? static_cast<double>(random.below(8)) : random.between(0.0, 8.0);
      parts.push_back({row, begin, begin + random.magnitude(0.01, 5.0)});
    }
    const bool may_go_back = random.chance(0.5);
    std::vector<RowPart> rest = parts;
    PartQueue queue{parts};
    Vector2d here{random.between(-5.0, 25.0), random.between(-5.0, 12.0)};
    while (!queue.empty()) {
      const auto distance = [&](const RowPart& part) {
        const double from_begin = (Vector2d{part.begin, part.row} - here).norm();
        const double from_end = (Vector2d{part.end, part.row} - here).norm();
        return may_go_back ? std::min(from_begin, from_end) : from_begin;
      };
      const auto [part, goes_back] = queue.take_nearest(here, may_go_back);
      const auto same = std::ranges::find_if(rest, [&part = part](const RowPart& other) {
        return other.row == part.row && other.begin == part.begin && other.end == part.end;
      });
      ASSERT_NE(same, rest.end());
      for (const RowPart& other : rest) EXPECT_GE(distance(other), distance(part));
      rest.erase(same);
      here = {goes_back ? part.begin : part.end, part.row};
    }
    EXPECT_TRUE(rest.empty());
  }
}

TEST(PartQueue, TakesRowsFromEitherSide) {
  const std::vector<RowPart> parts{{1.0, 5.0, 6.0}, {0.0, 0.0, 9.0}, {1.0, 1.0, 2.0}};
  PartQueue from_below{parts};
  PartQueue from_above{parts};
  std::vector<double> rising;
  std::vector<double> falling;
  while (!from_below.empty()) rising.push_back(from_below.take_outermost(false).part.begin);
  while (!from_above.empty()) falling.push_back(from_above.take_outermost(true).part.begin);
  EXPECT_EQ(rising, (std::vector{0.0, 1.0, 5.0}));
  EXPECT_EQ(falling, (std::vector{1.0, 5.0, 0.0}));
}

}  // namespace
}  // namespace sim::surface

#include "host-sim/stock/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "host-sim/stock/carver.hpp"
#include "tests/support/trials.hpp"

namespace sim::stock {
namespace {

constexpr StockBox kSlab{-5.0, -5.0, 45.0, 35.0, 2.0, -8.0};
constexpr double kDepth = 3.0;
constexpr double kFloor = kSlab.top - kDepth;
constexpr Cutter kFlat4{.kind = CutterKind::kFlat, .diameter_mm = 4.0};
constexpr Cutter kBall4{.kind = CutterKind::kBall, .diameter_mm = 4.0};

Ring rectangle(double x_min, double y_min, double x_max, double y_max) {
  return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

/// Clears a rectangle of poses by lines along X, and follows its border.
void clear(Carver& carver, const StockBox& poses, double step_mm) {
  const double z = poses.bottom;
  const int lines = static_cast<int>(std::ceil((poses.y_max - poses.y_min) / step_mm - 1.0e-9));
  for (int i = 0; i <= lines; ++i) {
    const double y = std::min(poses.y_min + i * step_mm, poses.y_max);
    carver.sweep({{poses.x_min, y, z}, {poses.x_max, y, z}});
  }
  carver.sweep({{poses.x_min, poses.y_min, z}, {poses.x_min, poses.y_max, z}});
  carver.sweep({{poses.x_max, poses.y_min, z}, {poses.x_max, poses.y_max, z}});
}

constexpr StockBox kPoses{2.0, 2.0, 38.0, 28.0, 0.0, kFloor};
const PocketTarget kPocket{{rectangle(0.0, 0.0, 40.0, 30.0)}, kDepth};

TEST(Comparison, OfAGoodPocketFindsNothingForSure) {
  double walls = 0.0;
  for (const double cell_mm : {0.1, 0.05}) {
    Stock stock{kSlab, cell_mm};
    Carver carver{stock, kFlat4};
    clear(carver, kPoses, 2.5);
    const PocketFigures figures = compared(stock, kFlat4, kPocket);
    EXPECT_EQ(figures.gouge.min_mm3, 0.0);
    EXPECT_EQ(figures.rest.min_mm3, 0.0);
    EXPECT_EQ(figures.deepest_gouge.min_mm, 0.0);
    EXPECT_EQ(figures.tallest_scallop.min_mm, 0.0);
    // The bounds differ along 140 mm of walls.
    EXPECT_LE(figures.gouge.max_mm3, 140.0 * kDepth * 2.5 * cell_mm);
    EXPECT_LE(figures.rest.max_mm3, 140.0 * kDepth * 4.0 * cell_mm);
    if (walls > 0.0) {
      EXPECT_LE(figures.gouge.max_mm3, 0.7 * walls);
    }
    walls = figures.gouge.max_mm3;
  }
}

TEST(Comparison, FindsARibBetweenTwoLines) {
  Stock stock{kSlab, 0.05};
  Carver carver{stock, kFlat4};
  StockBox low = kPoses;
  StockBox high = kPoses;
  low.y_max = 12.0;
  high.y_min = 17.0;  // The rib from 14 to 15 is wider at its ends, because the tool is round.
  clear(carver, low, 2.5);
  clear(carver, high, 2.5);
  const PocketFigures figures = compared(stock, kFlat4, kPocket);
  const double rib = (40.0 * 1.0 + 4.0 * (4.0 - std::numbers::pi)) * kDepth;
  EXPECT_LE(figures.rest.min_mm3, rib);
  EXPECT_GE(figures.rest.min_mm3, 0.85 * rib);
  EXPECT_GE(figures.rest.max_mm3, rib);
  EXPECT_NEAR(figures.tallest_rest.min_mm, kDepth, 1.0e-5);
  EXPECT_GT(figures.tallest_rest.y_mm, 12.0);
  EXPECT_LT(figures.tallest_rest.y_mm, 17.0);
  EXPECT_EQ(figures.tallest_scallop.min_mm, 0.0);
  EXPECT_EQ(figures.gouge.min_mm3, 0.0);
}

TEST(Comparison, FindsAGougeOfTheFloorAndOfAWall) {
  Stock stock{kSlab, 0.05};
  Carver carver{stock, kFlat4};
  clear(carver, kPoses, 2.5);
  carver.sweep({{10.0, 10.0, kFloor - 0.3}, {20.0, 10.0, kFloor - 0.3}});
  PocketFigures figures = compared(stock, kFlat4, kPocket);
  const double slot = 0.3 * (40.0 + 4.0 * std::numbers::pi);
  EXPECT_LE(figures.gouge.min_mm3, slot);
  EXPECT_GE(figures.gouge.min_mm3, 0.9 * slot);
  EXPECT_NEAR(figures.deepest_gouge.min_mm, 0.3, 1.0e-5);
  EXPECT_NEAR(figures.deepest_gouge.y_mm, 10.0, 2.0);
  // The cut is 0.4 mm into the upper wall.
  carver.sweep({{10.0, 28.4, kFloor}, {30.0, 28.4, kFloor}});
  const double before = figures.gouge.min_mm3;
  figures = compared(stock, kFlat4, kPocket);
  EXPECT_NEAR(figures.gouge.min_mm3 - before, 20.0 * 0.4 * kDepth, 5.0);
  EXPECT_NEAR(figures.deepest_gouge.min_mm, kDepth, 1.0e-5);
  EXPECT_GT(figures.deepest_gouge.y_mm, 30.0);
  EXPECT_LT(figures.deepest_gouge.y_mm, 30.4);
}

TEST(Comparison, FindsTheScallopsOfABall) {
  constexpr double kStep = 0.8;
  const double scallop = 2.0 - std::sqrt(4.0 - 0.25 * kStep * kStep);
  for (const double cell_mm : {0.1, 0.05}) {
    Stock stock{kSlab, cell_mm};
    Carver carver{stock, kBall4};
    clear(carver, kPoses, kStep);
    const PocketFigures figures = compared(stock, kBall4, kPocket);
    EXPECT_EQ(figures.gouge.min_mm3, 0.0);
    EXPECT_LE(figures.tallest_scallop.min_mm, scallop + 1.0e-6);
    // The ridge is as steep as its half angle: a cell away, it is lower by the corresponding
    // height.
    EXPECT_GE(figures.tallest_scallop.min_mm, scallop - 1.5 * cell_mm * 0.5 * kStep / 2.0);
    EXPECT_GE(figures.tallest_scallop.max_mm, scallop);
    const double strip = 0.5 * kStep;
    const double under =
        2.0 * strip - (strip * std::sqrt(4.0 - strip * strip) / 2.0 + 2.0 * std::asin(strip / 2.0));
    // There are ridges where poses are on both sides.
    const double ridges = 2.0 * under / kStep * 36.0 * 26.0;
    EXPECT_LE(figures.rest.min_mm3, ridges * 1.25);
    EXPECT_GE(figures.rest.max_mm3, ridges);
  }
}

TEST(Comparison, CallsNoRestWhereTheToolDoesNotFit) {
  // A neck of 3 mm leads to a wider area, and an island forms a neck of the same kind.
  const Ring outline{{0.0, 0.0},
                     {16.0, 0.0},
                     {16.0, 13.5},
                     {24.0, 13.5},
                     {24.0, 0.0},
                     {40.0, 0.0},
                     {40.0, 30.0},
                     {24.0, 30.0},
                     {24.0, 16.5},
                     {16.0, 16.5},
                     {16.0, 30.0},
                     {0.0, 30.0}};
  const PocketTarget target{{outline, rectangle(6.0, 10.0, 10.0, 20.0)}, kDepth};
  Stock stock{kSlab, 0.1};
  PocketFigures figures = compared(stock, kFlat4, target);
  // Nothing is cut: both wide areas are rest, but not the neck and the corners.
  const double corners = (4.0 - std::numbers::pi) * 8.0;
  const double rooms = 2.0 * 16.0 * 30.0 - 40.0 - corners;
  EXPECT_LE(figures.rest.min_mm3, rooms * kDepth);
  EXPECT_GE(figures.rest.min_mm3, 0.95 * rooms * kDepth);
  EXPECT_GE(figures.rest.max_mm3, rooms * kDepth);
  EXPECT_LE(figures.rest.max_mm3, 1.05 * rooms * kDepth);
  EXPECT_EQ(figures.gouge.max_mm3, 0.0);
  // For a tool that fits nowhere, no rest is reported.
  const Cutter large{.kind = CutterKind::kFlat, .diameter_mm = 35.0};
  EXPECT_EQ(compared(stock, large, target).rest.max_mm3, 0.0);
}

TEST(Comparison, TakesTheRadiusOfATaperedToolWithinTheStock) {
  // A V of 90 degrees that is 3 mm deep extends 3 mm to each side, although the tool is 20 mm wide.
  const Cutter cutter{.kind = CutterKind::kV, .diameter_mm = 20.0, .included_angle_deg = 90.0};
  const PocketTarget target{{rectangle(0.0, 0.0, 40.0, 8.0)}, kDepth};
  Stock stock{kSlab, 0.05};
  const PocketFigures figures = compared(stock, cutter, target);
  EXPECT_GT(figures.rest.min_mm3, 0.0);
  Carver carver{stock, cutter};
  clear(carver, {3.0, 3.0, 37.0, 5.0, 0.0, kFloor}, 0.02);
  const PocketFigures cleared = compared(stock, cutter, target);
  EXPECT_LE(cleared.tallest_rest.min_mm, 0.011);
  EXPECT_EQ(cleared.gouge.min_mm3, 0.0);
}

/// Returns whether a point is in a ring, by the angle by which the ring turns around it.
bool is_in(const Ring& ring, double x, double y) {
  double turned = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& a = ring[i];
    const auto& b = ring[(i + 1) % ring.size()];
    turned += std::remainder(std::atan2(b[1] - y, b[0] - x) - std::atan2(a[1] - y, a[0] - x),
                             2.0 * std::numbers::pi);
  }
  return std::abs(turned) > std::numbers::pi;
}

TEST(PlanRegion, KnowsEveryPointOfCellsThatNoRingCuts) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    std::mt19937_64 random{seed};
    std::uniform_real_distribution<double> share{0.0, 1.0};
    Ring ring;
    const int corners = 3 + static_cast<int>(random() % 9);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.8 * share(random)) / corners;
      const double radius = 2.0 + 13.0 * share(random);
      ring.push_back({20.0 + radius * std::cos(angle), 15.0 + radius * std::sin(angle)});
      // The corner lies on lines between cells.
      if (seed % 3 == 0) ring.back()[1] = std::round(ring.back()[1]);
    }
    const Stock stock{kSlab, 0.25 + share(random)};
    const PlanRegion region{{ring}, stock};
    for (int i = 0; i < 2'000; ++i) {
      const double x = kSlab.x_min + (kSlab.x_max - kSlab.x_min) * share(random);
      const double y = kSlab.y_min + (kSlab.y_max - kSlab.y_min) * share(random);
      const RegionPart part =
          region.part_of(static_cast<int>((x - kSlab.x_min) / stock.cell_x_mm()),
                         static_cast<int>((y - kSlab.y_min) / stock.cell_y_mm()));
      if (part == RegionPart::kEdge) continue;
      ASSERT_EQ(part == RegionPart::kInside, is_in(ring, x, y)) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace sim::stock

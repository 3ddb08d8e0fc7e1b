#include "host-sim/stock/surface_comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host-sim/plot/deviation_picture.hpp"
#include "host-sim/report/stock_text.hpp"
#include "host-sim/stock/carver.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::stock {
namespace {

constexpr StockBox kComparedBlock{0.0, 0.0, 12.0, 8.0, 1.0, -6.0};
constexpr double kComparedCell = 0.05;

/// Returns a plane over the block, with height `height` at the origin and slope `rise` along X.
surface::Mesh plane(double height, double rise) {
  const auto corner = [&](double x, double y) { return Eigen::Vector3d{x, y, height + rise * x}; };
  return {.points = {corner(-1, -1), corner(13, -1), corner(13, 9), corner(-1, 9)},
          .facets = {{0, 1, 2}, {0, 2, 3}}};
}

/// Carves rows of a flat tool at a height above a plane, at which the rim of the tool touches
/// first.
Stock rows_over(double height, double rise, const Cutter& cutter) {
  Stock stock{kComparedBlock, kComparedCell};
  Carver carver{stock, cutter};
  const double radius = 0.5 * cutter.diameter_mm;
  for (double y = -1.0; y <= 9.0; y += 0.5 * radius) {
    carver.sweep(
        {{-2.0, y, height + rise * (radius - 2.0)}, {14.0, y, height + rise * (radius + 14.0)}});
  }
  return stock;
}

TEST(SurfaceComparison, FindsTheRestThatALevelCutLeaves) {
  const Cutter cutter{.kind = CutterKind::kFlat, .diameter_mm = 3.0};
  const Stock stock = rows_over(-2.0, 0.0, cutter);
  const SurfaceFigures figures = compared(stock, cutter, plane(-2.25, 0.0)).figures;
  EXPECT_EQ(figures.cells, 240U * 160U);
  EXPECT_NEAR(figures.tallest_rest.min_mm, 0.25, 1.0e-5);
  EXPECT_NEAR(figures.tallest_rest.max_mm, 0.25, 1.0e-5);
  EXPECT_NEAR(figures.rest.min_mm3, 0.25 * 12.0 * 8.0, 1.0e-3);
  EXPECT_EQ(figures.gouge.max_mm3, 0.0);
  EXPECT_TRUE(figures.worst_gouges.empty());
  ASSERT_EQ(figures.worst_rests.size(), kMaxWorstPlaces);
  EXPECT_EQ(figures.worst_rests[0].unreachable_mm, 0.0);
}

TEST(SurfaceComparison, FindsAGougeWithItsPlaceAndDepth) {
  const Cutter cutter{.kind = CutterKind::kFlat, .diameter_mm = 1.0};
  const Cutter wide{.kind = CutterKind::kFlat, .diameter_mm = 3.0};
  Stock stock = rows_over(-2.0, 0.0, wide);
  Carver carver{stock, cutter};
  carver.sweep({{7.0, 3.0, 2.0}, {7.0, 3.0, -2.125}});
  const SurfaceComparison comparison = compared(stock, wide, plane(-2.0, 0.0));
  const SurfaceFigures& figures = comparison.figures;
  EXPECT_NEAR(figures.deepest_gouge.min_mm, 0.125, 1.0e-5);
  ASSERT_FALSE(figures.worst_gouges.empty());
  EXPECT_NEAR(figures.worst_gouges[0].off_mm, -0.125, 1.0e-5);
  EXPECT_NEAR(figures.worst_gouges[0].x_mm, 7.0, 0.5);
  EXPECT_NEAR(figures.worst_gouges[0].y_mm, 3.0, 0.5);
  EXPECT_NEAR(figures.gouge.min_mm3, 0.125 * 0.7854, 0.02);
  EXPECT_NEAR(comparison.map.at(140, 60), -0.125F, 1.0e-5F);
  EXPECT_NEAR(comparison.map.at(20, 20), 0.0F, 1.0e-5F);
  StockReport report;
  report.surface = figures;
  const std::vector<std::string> warnings = warnings_of(report, "job.nc");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("job.nc: the surface is gouged"), std::string::npos);
}

TEST(SurfaceComparison, MeasuresAtRightAnglesOnASlope) {
  const Cutter cutter{.kind = CutterKind::kFlat, .diameter_mm = 3.0};
  for (const double rise : {0.25, 0.1, -0.2}) {
    const double base = rise < 0.0 ? -1.0 : -4.0;
    // The rim at the front touches where the plane rises along the rows, the rim at the back where
    // it falls.
    Stock stock{kComparedBlock, kComparedCell};
    Carver carver{stock, cutter};
    const double above = 0.3;
    for (double y = -1.0; y <= 9.0; y += 0.7) {
      const auto tip = [&](double x) { return base + above + rise * x + std::abs(rise) * 1.5; };
      carver.sweep({{-2.0, y, tip(-2.0)}, {14.0, y, tip(14.0)}});
    }
    const SurfaceComparison comparison = compared(stock, cutter, plane(base, rise));
    EXPECT_NEAR(comparison.map.at(120, 80), above / std::hypot(1.0, rise), 0.5 * kComparedCell)
        << rise;
    EXPECT_EQ(comparison.figures.gouge.min_mm3, 0.0);
  }
}

TEST(SurfaceComparison, TellsWhatAToolLeavesWhereItDoesNotFit) {
  // In a groove of 90 degrees, a ball of 4 mm stops (√2 - 1) 2 mm above the bottom.
  const surface::Mesh groove{
      .points = {{-1, -1, 0}, {13, -1, 0}, {13, 4, -5}, {-1, 4, -5}, {13, 9, 0}, {-1, 9, 0}},
      .facets = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}}};
  const Cutter ball{.kind = CutterKind::kBall, .diameter_mm = 4.0};
  Stock stock{{0.0, 0.0, 12.0, 8.0, 1.0, -6.0}, kComparedCell};
  Carver carver{stock, ball};
  const double tip = -5.0 + (std::sqrt(2.0) - 1.0) * 2.0;
  carver.sweep({{-3.0, 4.0, tip}, {15.0, 4.0, tip}});
  for (double off = 0.05; off < 5.0; off += 0.05) {
    for (const double side : {-1.0, 1.0}) {
      carver.sweep({{-3.0, 4.0 + side * off, tip + off}, {15.0, 4.0 + side * off, tip + off}});
    }
  }
  const SurfaceFigures figures = compared(stock, ball, groove).figures;
  EXPECT_EQ(figures.gouge.min_mm3, 0.0);
  ASSERT_FALSE(figures.worst_rests.empty());
  const WorstPlace& worst = figures.worst_rests[0];
  EXPECT_NEAR(worst.y_mm, 4.0, 0.06);
  EXPECT_GT(worst.unreachable_mm, 0.5 * worst.off_mm);
  EXPECT_NEAR(worst.unreachable_mm, worst.off_mm, 0.1);
}

TEST(SurfaceComparison, SeesAWallBesideACellAsNear) {
  // A step of 3 mm, with stock that remains 0.2 mm beside it.
  const surface::Mesh step{
      .points = {{-1, -1, -4},
                 {6, -1, -4},
                 {6, 9, -4},
                 {-1, 9, -4},
                 {6, -1, -1},
                 {13, -1, -1},
                 {13, 9, -1},
                 {6, 9, -1}},
      .facets = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}, {1, 4, 7}, {1, 7, 2}}};
  const Cutter cutter{.kind = CutterKind::kFlat, .diameter_mm = 2.0};
  Stock stock{kComparedBlock, kComparedCell};
  Carver carver{stock, cutter};
  // Beside the step a rest of 0.2 mm in thickness remains.
  for (double x = 4.8; x > -2.0; x -= 0.7) carver.sweep({{x, -2.0, -4.0}, {x, 10.0, -4.0}});
  for (double x = 6.0; x < 14.0; x += 0.7) carver.sweep({{x, -2.0, -1.0}, {x, 10.0, -1.0}});
  const SurfaceFigures figures = compared(stock, cutter, step).figures;
  EXPECT_GT(figures.tallest_rest.min_mm, 2.5);
  ASSERT_FALSE(figures.worst_rests.empty());
  EXPECT_LT(figures.worst_rests[0].off_mm, 0.4);
  EXPECT_GT(figures.worst_rests[0].off_mm, 0.02);
  EXPECT_EQ(figures.gouge.min_mm3, 0.0);
}

TEST(SurfaceComparison, LeavesOutWhereThereIsNoSurface) {
  const Cutter cutter{.kind = CutterKind::kFlat, .diameter_mm = 3.0};
  surface::Mesh half = plane(-2.0, 0.0);
  for (Eigen::Vector3d& point : half.points) point.x() = std::min(point.x(), 6.0);
  const SurfaceComparison comparison = compared(rows_over(-2.0, 0.0, cutter), cutter, half);
  EXPECT_NEAR(static_cast<double>(comparison.figures.cells), 120.0 * 160.0, 160.0);
  EXPECT_TRUE(std::isnan(comparison.map.at(200, 80)));
}

TEST(SurfaceComparison, BoundsHoldTheTrueDifferenceOnRandomPlanes) {
  for (const std::uint64_t seed : proof::Trials{20}) {
    proof::Random random{seed};
    const double rise = random.between(-0.3, 0.3);
    const double above = random.between(-0.4, 0.4);
    const double base = -3.0 - 12.0 * std::max(0.0, rise) - 1.0 * std::abs(rise);
    const Cutter cutter{.kind = CutterKind::kFlat, .diameter_mm = 2.0};
    Stock stock{{0.0, 0.0, 12.0, 8.0, 1.0, -12.0}, 0.1};
    Carver carver{stock, cutter};
    // The rows run along Y, so that the stock is a staircase with a step for each row.
    const double x = 6.0;
    const double tip = base + rise * x + above;
    carver.sweep({{x, -2.0, tip}, {x, 10.0, tip}});
    const SurfaceFigures figures = compared(stock, cutter, plane(base, rise)).figures;
    // The deepest point is at the upper rim of the slot.
    const double deepest = -above + std::abs(rise);
    EXPECT_LE(figures.deepest_gouge.min_mm, std::max(0.0, deepest) + 1.0e-5);
    EXPECT_GE(figures.deepest_gouge.max_mm, figures.deepest_gouge.min_mm);
    EXPECT_GE(figures.deepest_gouge.min_mm, deepest - 0.2 * std::abs(rise) - 1.0e-5);
    EXPECT_GE(figures.tallest_rest.max_mm, figures.tallest_rest.min_mm);
  }
}

TEST(SurfaceComparison, RefusesMoreCellsThanItTakes) {
  EXPECT_EQ(fault_of_comparison(kComparedBlock, 0.05), "");
  EXPECT_NE(fault_of_comparison({0, 0, 1'000, 1'000, 0, -1}, 0.05).find("choose larger"),
            std::string::npos);
}

TEST(DeviationPicture, ListsTheWorstPlacesAndColoursBothSigns) {
  const Cutter cutter{.kind = CutterKind::kFlat, .diameter_mm = 3.0};
  Stock stock = rows_over(-2.0, 0.0, cutter);
  Carver carver{stock, cutter};
  carver.sweep({{7.0, 3.0, 2.0}, {7.0, 3.0, -2.125}});
  const std::string svg =
      draw_deviation("map.svg", compared(stock, cutter, plane(-2.05, 0.0)), "A title", "facts");
  for (const char* part : {"A title", "facts", "R1 +0.05", "G1 -0.07", "Off the surface, mm"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(hex(deviation_colour(0.0)), "#ffffff");
  EXPECT_EQ(hex(deviation_colour(1.0)), hex(deviation_colour(7.0)));
  const Colour left = deviation_colour(0.6);
  EXPECT_GT(left.blue, left.red);
  const Colour gouge = deviation_colour(-0.6);
  EXPECT_GT(gouge.red, gouge.blue);
}

}  // namespace
}  // namespace sim::stock

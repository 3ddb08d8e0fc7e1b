#include "host-sim/stock/carving.hpp"

#include <gtest/gtest.h>

namespace sim::stock {
namespace {

constexpr double kTrailMm = 0.01;

/// Returns the figures for a tool of 6 mm that moves straight down to a depth.
CarvingFigures driven_down_to(double depth_mm, Drive drive) {
  Stock stock{{0.0, 0.0, 20.0, 20.0, 0.0, -5.0}, 0.1};
  Carving carving{stock, {.diameter_mm = 6.0}, kTrailMm};
  carving.take({{{10.0, 10.0, 1.0}, {10.0, 10.0, -depth_mm}}, {7, drive}, 1.0});
  carving.end(1.0);
  return carving.figures();
}

// The line of the program to which a step belongs is known only within a few steps: the first step
// of a ramp may count for the plunge before it.
TEST(Carving, ReportsNoPlungeAndNoRapidByASkin) {
  EXPECT_EQ(driven_down_to(0.5 * kTrailMm, Drive::kFeed).plunges.count, 0U);
  EXPECT_EQ(driven_down_to(0.5 * kTrailMm, Drive::kRapid).rapids.count, 0U);
  EXPECT_GT(driven_down_to(0.5 * kTrailMm, Drive::kFeed).removed.min_mm3, 0.0);
}

TEST(Carving, ReportsPlungesAndRapidsInStockByTheirLine) {
  const CarvingFigures plunge = driven_down_to(0.5, Drive::kFeed);
  EXPECT_EQ(plunge.plunges.count, 1U);
  EXPECT_EQ(plunge.rapids.count, 0U);
  EXPECT_EQ(plunge.plunges.lines[0].line, 7);
  const CarvingFigures rapid = driven_down_to(0.5, Drive::kRapid);
  EXPECT_EQ(rapid.rapids.count, 1U);
  EXPECT_EQ(rapid.plunges.count, 0U);
}

}  // namespace
}  // namespace sim::stock

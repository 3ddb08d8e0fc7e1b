#include "host-sim/stock/engagement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host-sim/stock/carving.hpp"

namespace sim::stock {
namespace {

constexpr StockBox kPlate{0.0, 0.0, 60.0, 40.0, 0.0, -10.0};
constexpr double kRadius = 5.0;
constexpr Cutter kFlat10{.kind = CutterKind::kFlat, .diameter_mm = 2.0 * kRadius};

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

void expect_about(const Engagement& found, double wanted_deg, double off_deg) {
  EXPECT_LE(found.min_deg, wanted_deg + 0.3);
  EXPECT_GE(found.max_deg, wanted_deg - 0.3);
  EXPECT_NEAR(found.middle_deg(), wanted_deg, off_deg);
}

TEST(Engagement, OfASlotIsHalfATurn) {
  for (const Pose& to : {Pose{40.0, 20.0, -3.0}, Pose{36.0, 28.0, -3.0}, Pose{20.0, 30.0, -3.0}}) {
    Stock stock{kPlate, 0.05};
    Carver carver{stock, kFlat10};
    const Pose from{20.0, 20.0, -3.0};
    carver.sweep({from, from});
    expect_about(greatest_engagement(stock, kRadius, {from, to}), 180.0, 0.5);
    // Farther along the path it is half a turn, too; on the way back it is zero.
    carver.sweep({from, to});
    const Pose on{2.0 * to.x_mm - from.x_mm, 2.0 * to.y_mm - from.y_mm, to.z_mm};
    expect_about(greatest_engagement(stock, kRadius, {to, on}), 180.0, 0.5);
    const Engagement back = greatest_engagement(stock, kRadius, {to, from});
    EXPECT_EQ(back.min_deg, 0.0);
    // Cells of the walls are cut in part: the error at either side may be one and a half cells.
    EXPECT_LE(back.max_deg, 2.0 * degrees(std::acos(1.0 - 0.075 / kRadius)));
  }
}

TEST(Engagement, OfAStepOverIsThatOfTheFormula) {
  for (const double step : {0.5, 1.0, 2.5, 5.0, 7.5, 9.5}) {
    for (const double slant : {0.0, 0.17}) {
      Stock stock{kPlate, 0.05};
      Carver carver{stock, kFlat10};
      // The tool runs beside a slot, far from its ends.
      carver.sweep({{-20.0, 10.0 - 20.0 * slant, -3.0}, {80.0, 10.0 + 80.0 * slant, -3.0}});
      const double off = step * std::hypot(1.0, slant);
      const Pose from{20.0, 10.0 + 20.0 * slant + off, -3.0};
      const Pose to{24.0, 10.0 + 24.0 * slant + off, -3.0};
      carver.sweep({{-20.0, 10.0 - 20.0 * slant + off, -3.0}, from});
      const Engagement found = greatest_engagement(stock, kRadius, {from, to});
      const double wanted = degrees(std::acos(1.0 - step / kRadius));
      expect_about(found, wanted, 1.0);
      const double cells = 2.0 * 0.05 / (kRadius * std::sin(wanted * std::numbers::pi / 180.0));
      EXPECT_LE(found.max_deg - found.min_deg, degrees(1.4 * cells)) << step;
    }
  }
}

TEST(Engagement, IsNothingAboveTheStockAndOnAFloor) {
  Stock stock{kPlate, 0.05};
  Carver carver{stock, kFlat10};
  EXPECT_EQ(greatest_engagement(stock, kRadius, {{20, 20, 0}, {30, 20, 0}}).max_deg, 0.0);
  EXPECT_EQ(greatest_engagement(stock, kRadius, {{20, 20, 0}, {20, 20, -5}}).max_deg, 0.0);
  for (double y = 5.0; y < 40.0; y += 5.0) carver.sweep({{-10, y, -3.0}, {70, y, -3.0}});
  EXPECT_EQ(greatest_engagement(stock, kRadius, {{20, 20, -3}, {30, 20, -3}}).max_deg, 0.0);
  expect_about(greatest_engagement(stock, kRadius, {{20, 20, -3.1}, {30, 20, -3.1}}), 180.0, 0.5);
}

DrivenStretch driven(const Pose& from, const Pose& to, int line, bool is_rapid, double end_s) {
  return {{from, to}, {line, is_rapid ? Drive::kRapid : Drive::kFeed}, end_s};
}

TEST(Carving, NamesRapidsAndPlungesInStockByLine) {
  Stock stock{kPlate, 0.1};
  Carving carving{stock, kFlat10, 0.01};
  carving.take(driven({10, 10, 5}, {10, 10, 0}, 1, true, 1.0));
  carving.take(driven({10, 10, 0}, {10, 10, -3}, 2, false, 2.0));  // Plunge.
  carving.take(driven({10, 10, -3}, {30, 10, -3}, 3, false, 3.0));
  carving.take(driven({30, 10, -3}, {10, 10, -3}, 4, true, 4.0));  // Back in its own slot.
  carving.take(driven({10, 10, -3}, {10, 10, 5}, 5, true, 5.0));
  carving.take(driven({10, 10, 5}, {30, 30, -1}, 6, true, 6.0));    // Into the plate.
  carving.take(driven({30, 30, -1}, {35, 30, -5}, 7, false, 7.0));  // A ramp.
  carving.take(driven({35, 30, -5}, {35, 30, -6}, 8, false, 8.0));  // Plunge.
  carving.end(9.0);
  const CarvingFigures& figures = carving.figures();
  ASSERT_EQ(figures.rapids.lines.size(), 1U);
  EXPECT_EQ(figures.rapids.lines[0].line, 6);
  EXPECT_GT(figures.rapids.lines[0].min_mm3, 50.0);
  EXPECT_EQ(figures.rapids.lines[0].at_s, 6.0);
  ASSERT_EQ(figures.plunges.lines.size(), 2U);
  EXPECT_EQ(figures.plunges.lines[0].line, 2);
  EXPECT_NEAR(figures.plunges.lines[0].min_mm3, 3.0 * 25.0 * std::numbers::pi, 8.0);
  EXPECT_EQ(figures.plunges.lines[1].line, 8);
  ASSERT_TRUE(figures.engagement.has_value());
  EXPECT_EQ(figures.engagement->line, 3);
}

TEST(Carving, ListsTheFirstLinesAndCountsAll) {
  Stock stock{kPlate, 0.5};
  Carving carving{stock, kFlat10, 0.001};
  for (int line = 1; line <= 150; ++line) {
    const double z = -0.04 * line;
    carving.take(driven({20, 20, z + 0.04}, {20, 20, z + 0.02}, line, false, line));
    carving.take(driven({20, 20, z + 0.02}, {20, 20, z}, line, false, line));
  }
  const LineCuts& plunges = carving.figures().plunges;
  EXPECT_EQ(plunges.count, 150U);
  ASSERT_EQ(plunges.lines.size(), LineCuts::kMaxListed);
  for (std::size_t i = 0; i < plunges.lines.size(); ++i) {
    EXPECT_EQ(plunges.lines[i].line, static_cast<int>(i) + 1);
    EXPECT_NEAR(plunges.lines[i].min_mm3, 0.04 * 25.0 * std::numbers::pi, 0.6);
  }
}

TEST(Carving, KeepsTheRemovedVolumeOverTime) {
  Stock stock{kPlate, 0.2};
  Carving carving{stock, kFlat10, 0.01};
  constexpr int kStretches = 5'000;
  double x = 0.0;
  for (int i = 1; i <= kStretches; ++i) {
    const double to = 60.0 * i / kStretches;
    carving.take(driven({x, 20, -2}, {to, 20, -2}, 1, false, 0.1 * i));
    x = to;
  }
  carving.end(501.0);
  const CarvingFigures& figures = carving.figures();
  ASSERT_LE(figures.over_time.size(), CarvingFigures::kMaxTimes);
  ASSERT_GE(figures.over_time.size(), CarvingFigures::kMaxTimes / 2 - 1);
  for (std::size_t i = 1; i < figures.over_time.size(); ++i) {
    EXPECT_LT(figures.over_time[i - 1].time_s, figures.over_time[i].time_s);
    EXPECT_LE(figures.over_time[i - 1].removed.min_mm3, figures.over_time[i].removed.min_mm3);
  }
  EXPECT_EQ(figures.over_time.back().time_s, 501.0);
  EXPECT_EQ(figures.over_time.back().removed.max_mm3, figures.removed.max_mm3);
  EXPECT_EQ(figures.removed.max_mm3, stock.removed().max_mm3);
}

}  // namespace
}  // namespace sim::stock

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "host-sim/stock/carver.hpp"

namespace sim::stock {
namespace {

using std::numbers::pi;

constexpr StockBox kBlock{0.0, 0.0, 40.0, 20.0, 0.0, -12.0};
constexpr Cutter kFlat6{.kind = CutterKind::kFlat, .diameter_mm = 6.0};
constexpr Cutter kBall6{.kind = CutterKind::kBall, .diameter_mm = 6.0};
constexpr Cutter kBull6{.kind = CutterKind::kBull, .diameter_mm = 6.0, .corner_radius_mm = 1.0};
constexpr Cutter kV60{.kind = CutterKind::kV, .diameter_mm = 12.0, .included_angle_deg = 60.0};

VolumeBounds carved(const Cutter& cutter, const Stretch& stretch, double cell_mm) {
  Stock stock{kBlock, cell_mm};
  Carver carver{stock, cutter};
  carver.sweep({stretch.from, stretch.from});
  carver.sweep(stretch);
  return stock.removed();
}

/// Expects that the volume is between the bounds. Both bounds must approach it about in proportion
/// to the size of the cells.
void expect_volume(const Cutter& cutter, const Stretch& stretch, double volume_mm3) {
  double gap_before = 0.0;
  for (const double cell_mm : {0.2, 0.1, 0.05}) {
    const VolumeBounds removed = carved(cutter, stretch, cell_mm);
    EXPECT_LE(removed.min_mm3, volume_mm3) << cell_mm;
    EXPECT_GE(removed.max_mm3, volume_mm3) << cell_mm;
    const double gap = removed.max_mm3 - removed.min_mm3;
    EXPECT_LE(gap, volume_mm3 * 1.6 * cell_mm) << cell_mm;
    if (gap_before > 0.0) {
      EXPECT_LE(gap, 0.6 * gap_before) << cell_mm;
    }
    gap_before = gap;
  }
}

TEST(StockVolume, OfASlotWithRoundEnds) {
  const Stretch slot{{10.013, 10.007, -2.0}, {30.019, 10.007, -2.0}};
  expect_volume(kFlat6, slot, 2.0 * (6.0 * 20.006 + 9.0 * pi));
  const Stretch slanted{{10.0, 8.0, -2.0}, {26.0, 12.0, -2.0}};
  expect_volume(kFlat6, slanted, 2.0 * (6.0 * std::hypot(16.0, 4.0) + 9.0 * pi));
}

TEST(StockVolume, OfAHoleByEachTool) {
  const auto drilled = [](double depth_mm) {
    return Stretch{{20.0, 10.0, 1.0}, {20.0, 10.0, -depth_mm}};
  };
  expect_volume(kFlat6, drilled(5.0), 9.0 * pi * 5.0);
  expect_volume(kBall6, drilled(2.0), pi * 4.0 * (3.0 - 2.0 / 3.0));
  expect_volume(kBall6, drilled(5.0), 2.0 / 3.0 * pi * 27.0 + 9.0 * pi * 2.0);
  const double radius = 6.0 * std::tan(pi / 6.0);
  expect_volume(kV60, drilled(6.0), pi * radius * radius * 6.0 / 3.0);
  const double nose = pi * (4.0 + 2.0 * 2.0 * pi / 4.0 + 2.0 / 3.0);
  expect_volume(kBull6, drilled(4.0), nose + 9.0 * pi * 3.0);
}

TEST(StockVolume, OfAVWithAFlatTip) {
  const Cutter cutter{.kind = CutterKind::kV,
                      .diameter_mm = 8.0,
                      .included_angle_deg = 90.0,
                      .tip_diameter_mm = 1.0};
  const double outer = 0.5 + 2.0;
  const double volume = pi * 2.0 / 3.0 * (outer * outer + outer * 0.5 + 0.25);
  expect_volume(cutter, {{20.0, 10.0, 1.0}, {20.0, 10.0, -2.0}}, volume);
}

// Over each point of a slanted path downwards, the last pose that reaches it cuts deepest.
TEST(StockVolume, OfASlantedRamp) {
  expect_volume(kFlat6, {{10.0, 10.0, 0.0}, {30.0, 10.0, -4.0}}, 3.0 * 20.0 * 4.0 + 9.0 * pi * 4.0);
  expect_volume(kFlat6, {{30.0, 10.0, -4.0}, {10.0, 10.0, 0.0}}, 3.0 * 20.0 * 4.0 + 9.0 * pi * 4.0);
}

TEST(StockVolume, OfAGrooveByABall) {
  const double depth = 1.5;
  const double segment =
      9.0 * std::acos(1.5 / 3.0) - 1.5 * std::sqrt(2.0 * 3.0 * depth - depth * depth);
  expect_volume(kBall6,
                {{10.0, 10.0, -depth}, {30.0, 10.0, -depth}},
                20.0 * segment + pi * depth * depth * (3.0 - depth / 3.0));
}

TEST(StockVolume, OfAGrooveByAV) {
  const double half = 3.0 * std::tan(pi / 6.0);
  expect_volume(kV60,
                {{10.0, 10.0, -3.0}, {30.0, 10.0, -3.0}},
                20.0 * half * 3.0 + pi * half * half * 3.0 / 3.0);
}

TEST(StockVolume, EndsAtTheRimAndAtTheBottom) {
  // The path runs along the lower side, over both ends and through the bottom: half a slot is
  // outside.
  const Stretch along{{-5.0, 0.0, -15.0}, {45.0, 0.0, -15.0}};
  for (const double cell_mm : {0.3, 0.1, 0.05}) {  // 0.3 does not divide the sides.
    const VolumeBounds removed = carved(kFlat6, along, cell_mm);
    EXPECT_LE(removed.min_mm3, 40.0 * 3.0 * 12.0);
    EXPECT_GE(removed.max_mm3, 40.0 * 3.0 * 12.0);
    EXPECT_LE(removed.max_mm3 - removed.min_mm3, 40.0 * 12.0 * 2.0 * cell_mm);
  }
}

TEST(StockVolume, IsNothingAboveAndBesideTheStock) {
  for (const Stretch& stretch : {Stretch{{5.0, 5.0, 0.0}, {30.0, 9.0, 0.0}},
                                 Stretch{{5.0, -3.1, -5.0}, {30.0, -3.1, -5.0}},
                                 Stretch{{-60.0, 5.0, -5.0}, {-20.0, 5.0, -5.0}},
                                 Stretch{{5.0, 5.0, 0.0}, {5.0, 5.0, 20.0}}}) {
    Stock stock{kBlock, 0.1};
    Carver carver{stock, kFlat6};
    EXPECT_EQ(carver.sweep(stretch), 0.0);
    EXPECT_EQ(stock.removed().max_mm3, 0.0);
    EXPECT_EQ(stock.carved_bytes(), 0U);
  }
}

TEST(StockVolume, OfOneStretchIsWhatIsNewInIt) {
  Stock stock{kBlock, 0.05};
  Carver carver{stock, kFlat6};
  const Stretch first{{10.0, 10.0, -2.0}, {20.0, 10.0, -2.0}};
  EXPECT_NEAR(carver.sweep(first), 2.0 * (60.0 + 9.0 * pi), 6.0);
  EXPECT_EQ(carver.sweep({first.to, first.from}), 0.0);
  EXPECT_NEAR(carver.sweep({first.from, {20.0, 10.0, -3.0}}, 2.0), 0.0, 1.0e-9);
  EXPECT_NEAR(carver.sweep({{20.0, 10.0, -3.0}, {25.0, 10.0, -3.0}}), 5.0 * 6.0 * 3.0, 4.0);
}

TEST(StockVolume, TakesMemoryForTouchedTilesOnly) {
  Stock stock{{0.0, 0.0, 2'000.0, 1'000.0, 0.0, -20.0}, 0.05};
  Carver carver{stock, kFlat6};
  carver.sweep({{1'000.0, 500.0, -1.0}, {1'010.0, 500.0, -1.0}});
  // The carved area is 16 by 6 mm, on tiles of 3.2 mm.
  EXPECT_LE(stock.carved_bytes(), std::size_t{6} * 3 * 32'768);
  EXPECT_GE(stock.carved_bytes(), std::size_t{5} * 2 * 32'768);
}

TEST(StockFault, NamesRangeAndUnit) {
  EXPECT_EQ(fault_of(kBlock, 0.05), "");
  EXPECT_EQ(fault_of({5.0, 0.0, 5.0, 1.0, 0.0, -1.0}, 0.05),
            "X of the stock is 5 to 5 mm; the second number must be greater");
  EXPECT_EQ(fault_of({0.0, 0.0, 5.0, 1.0, 0.0, std::nan("")}, 0.05),
            "Z of the stock is nan to 0 mm; it must be within -100000 to 100000 mm");
  EXPECT_EQ(fault_of(kBlock, 0.0), "the stock's cells are 0 mm; they must be 0.001 to 10 mm");
  EXPECT_NE(fault_of({0.0, 0.0, 9'000.0, 9'000.0, 0.0, -1.0}, 0.01), "");
  EXPECT_NE(fault_of({0.0, 0.0, 9.0, 9.0, 0.0, -1'001.0}, 0.01), "");
  EXPECT_EQ(fault_of(kBull6), "");
  EXPECT_EQ(fault_of(Cutter{.diameter_mm = 0.0}),
            "the tool's diameter is 0 mm; it must be 0.01 to 500 mm");
  EXPECT_NE(fault_of(Cutter{.kind = CutterKind::kBull, .corner_radius_mm = 3.1}), "");
  EXPECT_NE(fault_of(Cutter{.kind = CutterKind::kV, .included_angle_deg = 180.0}), "");
  EXPECT_NE(fault_of(Cutter{.kind = CutterKind::kV, .tip_diameter_mm = 6.0}), "");
}

}  // namespace
}  // namespace sim::stock

#include "host-sim/pocket/strategy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "host-sim/contour/contour_text.hpp"
#include "host-sim/pocket/fitting_radius.hpp"

namespace sim::pocket {
namespace {

using cnc::pocket::Use;

constexpr const char* kRoom = "0 0\n60 0\n60 40\n0 40\nclosed\n";

StrategyOptions options_of(Strategy strategy) {
  StrategyOptions options;
  options.strategy = strategy;
  options.pocket.clearing = {.tool_radius = 3.0, .corner_radius = 0.3, .stepover = 6.0};
  options.pocket.entry = {cnc::pocket::EntryKind::kHelix, 0.05, 2.7};
  options.pocket.depth = 6.0;
  options.pocket.depth_step = 2.5;
  return options;
}

MilledPocket milled(const char* text, Strategy strategy, double radius_mm = 3.0) {
  const Contour pocket = contour_from_text(text, "test");
  return StrategyPlanner{options_of(strategy)}.mill(pocket.view(), radius_mm);
}

TEST(Strategies, MillEqualLevelsEachFromTheFloorAbove) {
  for (const Strategy strategy : {Strategy::kContour, Strategy::kAdaptive}) {
    const MilledPocket path = milled(kRoom, strategy);
    EXPECT_EQ(path.levels, 3U);
    std::set<double> floors;
    for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
      const std::uint32_t begin = path.path().row_begin(row);
      const double above = path.points[begin].z;
      for (std::uint32_t i = begin; i < path.row_ends[row]; ++i) {
        EXPECT_LE(path.points[i].z, above + 1.0e-12);
        EXPECT_GE(path.points[i].z, above - 2.0 - 1.0e-9);
      }
      floors.insert(std::round(1.0e6 * path.points[path.row_ends[row] - 1].z));
    }
    EXPECT_EQ(floors, (std::set<double>{-6.0e6, -4.0e6, -2.0e6}));
  }
}

TEST(Strategies, AdaptivePassesAreLight) {
  const MilledPocket path = milled(kRoom, Strategy::kAdaptive);
  double light_mm = 0.0;
  double full_mm = 0.0;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const double chord = (path.points[i + 1].point() - path.points[i].point()).norm();
    if (path.points[i].use == Use::kLight) light_mm += chord;
    if (path.points[i].use == Use::kPass) full_mm += chord;
  }
  EXPECT_GT(light_mm, full_mm);
  EXPECT_TRUE(path.narrow.empty());
  const MilledPocket contours = milled(kRoom, Strategy::kContour);
  EXPECT_TRUE(std::ranges::none_of(contours.points,
                                   [](const auto& point) { return point.use == Use::kLight; }));
}

/// Returns the least distance of rows from the walls of kRoom.
double min_distance(const MilledPocket& path, std::size_t first_row, std::size_t end_row) {
  double least = 1.0e9;
  for (std::uint32_t i = path.path().row_begin(first_row); i < path.row_ends[end_row - 1]; ++i) {
    const auto& point = path.points[i];
    least = std::min({least, point.x, point.y, 60.0 - point.x, 40.0 - point.y});
  }
  return least;
}

TEST(Strategies, LeaveWhatPassesAlongTheWallsTakeOff) {
  const Contour pocket = contour_from_text(kRoom, "test");
  for (const Strategy strategy : {Strategy::kContour, Strategy::kAdaptive, Strategy::kZigzag}) {
    StrategyOptions options = options_of(strategy);
    options.pocket.clearing.stepover = 4.0;
    options.finish_mm = 0.3;
    const MilledPocket path = StrategyPlanner{options}.mill(pocket.view(), 3.0);
    const std::size_t rows = path.row_ends.size();
    // There is one row for each level.
    EXPECT_NEAR(min_distance(path, 0, rows - 3), 3.3, 1.0e-9);
    for (std::size_t row = rows - 3; row < rows; ++row) {
      EXPECT_NEAR(min_distance(path, row, row + 1), 3.0, 1.0e-9);
      const auto& first = path.points[path.path().row_begin(row)];
      const auto& arc = path.points[path.path().row_begin(row) + 1];
      const auto& last = path.points[path.row_ends[row] - 1];
      // The tool descends in the cleared middle, follows an arc of a quarter turn to the wall, and
      // leaves by another one.
      EXPECT_EQ(first.point(), arc.point());
      EXPECT_EQ(first.use, Use::kLink);
      EXPECT_NEAR(arc.bulge, std::sqrt(2.0) - 1.0, 1.0e-9);
      EXPECT_NEAR(path.points[path.row_ends[row] - 2].bulge, std::sqrt(2.0) - 1.0, 1.0e-9);
      const double away = std::min({last.x, last.y, 60.0 - last.x, 40.0 - last.y});
      EXPECT_GE(away, 3.3);
    }
  }
}

TEST(Strategies, TakeTheAllowanceOfTheFloorOffInALevelOfItsOwn) {
  const Contour pocket = contour_from_text(kRoom, "test");
  for (const Strategy strategy :
       {Strategy::kContour, Strategy::kSpiral, Strategy::kAdaptive, Strategy::kZigzag}) {
    StrategyOptions options = options_of(strategy);
    options.pocket.clearing.stepover = 2.0;
    options.floor_mm = 1.0;
    options.finish_mm = 0.3;
    StrategyPlanner planner{options};
    for (int i = 0; i < 2; ++i) {  // The depth is the same once more.
      const MilledPocket path = planner.mill(pocket.view(), 3.0);
      EXPECT_EQ(path.levels, 3U);
      std::set<double> floors;
      for (const std::uint32_t end : path.row_ends) {
        floors.insert(std::round(1.0e6 * path.points[end - 1].z));
      }
      EXPECT_EQ(floors, (std::set<double>{-6.0e6, -5.0e6, -2.5e6}));
      EXPECT_NEAR(path.points.back().z, -6.0, 1.0e-9);
    }
  }
}

TEST(Strategies, HaveLinesBeforeTheirLeadsWhereACompensationNeedsThem) {
  const Contour pocket = contour_from_text(kRoom, "test");
  StrategyOptions options = options_of(Strategy::kContour);
  options.finish_mm = 0.3;
  options.has_lead_lines = true;
  const MilledPocket path = StrategyPlanner{options}.mill(pocket.view(), 3.0);
  const std::size_t rows = path.row_ends.size();
  for (std::size_t row = rows - 3; row < rows; ++row) {
    const std::uint32_t begin = path.path().row_begin(row);
    const std::uint32_t end = path.row_ends[row];
    EXPECT_EQ(path.points[begin + 1].use, Use::kLeadIn);
    EXPECT_EQ(path.points[end - 2].use, Use::kLeadOut);
    // Both lines are tangent to their arcs, at right angles to the wall, and as long as the tool is
    // wide.
    const cnc::WideVec2 in = path.points[begin + 2].point() - path.points[begin + 1].point();
    const cnc::WideVec2 out = path.points[end - 1].point() - path.points[end - 2].point();
    EXPECT_NEAR(in.norm(), 3.0, 1.0e-9);
    EXPECT_NEAR((in + out).norm(), 0.0, 1.0e-9);
    EXPECT_NEAR(std::min(std::abs(in.x()), std::abs(in.y())), 0.0, 1.0e-9);
  }
  const Contour slot = contour_from_text("0 0\n60 0\n60 6.4\n0 6.4\nclosed\n", "test");
  EXPECT_THROW(static_cast<void>(StrategyPlanner{options}.mill(slot.view(), 3.0)), NoPocketPath);
}

TEST(Strategies, FinishWhatIsTooNarrowForTheAllowance) {
  const Contour slot = contour_from_text("0 0\n60 0\n60 6.4\n0 6.4\nclosed\n", "test");
  StrategyOptions options = options_of(Strategy::kContour);
  options.finish_mm = 0.3;
  const MilledPocket path = StrategyPlanner{options}.mill(slot.view(), 3.0);
  EXPECT_EQ(path.levels, 3U);
  EXPECT_EQ(path.row_ends.size(), 3U);
  EXPECT_EQ(path.points[0].use, Use::kEntry);
}

TEST(FittingRadius, IsALittleLessInSlotsAsWideAsTheTool) {
  ContourOffset offsetter;
  const auto fitting = [&](const char* text) {
    return fitting_radius(contour_from_text(text, "test").view(), 3.0, offsetter);
  };
  constexpr double kTight = 3.0 - 0.0005;
  EXPECT_EQ(fitting("0 0\n60 0\n60 6\n0 6\nclosed\n"), kTight);
  EXPECT_EQ(fitting("0 0\n60 0 1\n60 6\n0 6 1\nclosed\n"), kTight);  // A slot with round ends.
  EXPECT_EQ(fitting("3 0 1\n-3 0 1\nclosed\n"), kTight);
  // A slot as an arm of a room, and slots between two islands and the walls.
  EXPECT_EQ(fitting("0 0\n30 0\n30 10\n60 10\n60 16\n30 16\n30 30\n0 30\nclosed\n"), kTight);
  EXPECT_EQ(fitting("0 0\n60 0\n60 40\n0 40\nclosed\n6 6\n6 34\n54 34\n54 6\nclosed\n"), kTight);
  EXPECT_EQ(fitting("0 0\n60 0\n60 5.99\n0 5.99\nclosed\n"), 0.0);
  EXPECT_EQ(fitting("0 0\n60 0\n60 6.01\n0 6.01\nclosed\n"), 3.0);
  EXPECT_EQ(fitting("0 0\n30 0\n30 10\n60 10\n60 15.9\n30 15.9\n30 30\n0 30\nclosed\n"), 3.0);
  EXPECT_EQ(fitting(kRoom), 3.0);
}

TEST(Strategies, MillSlotsAsWideAsTheToolFromEndToEnd) {
  for (const char* slot : {"0 0\n60 0\n60 6\n0 6\nclosed\n",
                           "3 0\n57 0 1\n57 6\n3 6 1\nclosed\n",
                           "-10 -12\n20 -12\n20 0\n57 0 1\n57 6\n20 6\n20 18\n-10 18\nclosed\n"}) {
    ContourOffset offsetter;
    const double radius_mm = fitting_radius(contour_from_text(slot, "test").view(), 3.0, offsetter);
    for (const Strategy strategy :
         {Strategy::kContour, Strategy::kSpiral, Strategy::kAdaptive, Strategy::kZigzag}) {
      const MilledPocket path = milled(slot, strategy, radius_mm);
      double left = 60.0;
      double right = 0.0;
      for (const auto& point : path.points) {
        if (point.x > 24.0) {
          EXPECT_NEAR(point.y, 3.0, 0.001);
        }
        left = std::min(left, point.x);
        right = std::max(right, point.x);
      }
      EXPECT_LE(left, 3.001) << slot;
      EXPECT_NEAR(right, 57.0, 0.001) << slot;
    }
  }
}

TEST(ThinChips, AreMadeUpForByTheFeed) {
  EXPECT_NEAR(thin_chip_factor(30.0), 2.0, 1.0e-12);
  EXPECT_NEAR(thin_chip_factor(60.0), 2.0 / std::sqrt(3.0), 1.0e-12);
  EXPECT_EQ(thin_chip_factor(90.0), 1.0);
  EXPECT_EQ(thin_chip_factor(150.0), 1.0);
}

}  // namespace
}  // namespace sim::pocket

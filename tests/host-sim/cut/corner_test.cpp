#include "host-sim/cut/corner.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host-sim/cut/cut_report.hpp"
#include "tests/host-sim/cut/support.hpp"

namespace sim::cut {
namespace {

constexpr double kPi = std::numbers::pi;

/// A part with five outer corners and an inner one, a hole with four inner corners, and a part with
/// four rounded corners.
constexpr const char* kAngle =
    "<path d=\"M10 20H40V60H70V80H10Z\"/><rect x=\"15\" y=\"25\" width=\"10\" height=\"10\"/>"
    "<rect x=\"50\" y=\"20\" width=\"12\" height=\"12\" rx=\"2\"/>";

CutPlan planned(const std::string& content, const LayerSettings& settings) {
  return plan_of(drawing::read(drawing::svg_of(content)), settings);
}

std::size_t count_of(const CutPlan& plan, Purpose purpose) {
  std::size_t count = 0;
  for (const Cut& cut : plan.cuts) {
    count += static_cast<std::size_t>(std::ranges::count(cut.strokes, purpose, &Stroke::purpose));
  }
  return count;
}

TEST(Corners, AreWhereTheDrawingTurnsSharplyAndNotWhereItIsRound) {
  const CutPlan plan = planned(kAngle, {});
  std::vector<std::size_t> counts;
  for (const Cut& cut : plan.cuts) counts.push_back(cut.corners.size());
  EXPECT_THAT(counts, testing::UnorderedElementsAre(6U, 4U, 0U));
  EXPECT_EQ(count_of(plan, Purpose::kCornerLoop), 0U);
  const CutFigures figures = figures_of(plan);
  EXPECT_EQ(figures.corners, 10U);
  EXPECT_EQ(figures.corner_loops + figures.corner_dwells, 0U);
}

TEST(Corners, BelowTheAngleAreNone) {
  constexpr const char* kHexagon =
      "<path d=\"M20 0L40 11.547V34.641L20 46.188L0 34.641V11.547Z\"/>";
  EXPECT_EQ(figures_of(planned(kHexagon, {.corner_angle_deg = 59.0})).corners, 6U);
  EXPECT_EQ(figures_of(planned(kHexagon, {.corner_angle_deg = 61.0})).corners, 0U);
}

/// A loop continues straight on, makes three quarters of a turn to the right, and continues
/// straight on. It replaces a quarter turn of radius h. Its lines are 2 (h + R) longer than the
/// path to the intersection of the kerf's lines, and its arc is 3/2 π R.
TEST(CornerLoops, PassOuterCornersAndInnerOnesRest) {
  constexpr double kRadius = 2.0;
  const CutPlan plan = planned(
      kAngle, {.corner_loop_mm = kRadius, .corner_dwell_s = 0.25, .corner_angle_deg = 45.0});
  const CutFigures figures = figures_of(plan);
  EXPECT_EQ(figures.corner_loops, 5U);
  EXPECT_EQ(figures.corner_dwells, 5U);
  EXPECT_DOUBLE_EQ(figures.corner_dwell_s, 1.25);
  const double longer = 2.0 * (kHalf + kRadius) + 1.5 * kPi * kRadius - 0.5 * kPi * kHalf;
  EXPECT_NEAR(figures.corner_loop_mm, 5.0 * longer, 1.0e-6);
  EXPECT_NEAR(figures.cut_length_mm - figures_of(planned(kAngle, {})).cut_length_mm,
              figures.corner_loop_mm,
              1.0e-6);
  const std::string program = program_of(
      plan, drawing::read(drawing::svg_of(kAngle)), {2800.0}, cnc::gcode::PrintGrid{4}, {});
  std::size_t dwells = 0;
  for (std::size_t at = 0; (at = program.find("G4 P0.250\n", at)) != std::string::npos; ++at) {
    ++dwells;
  }
  EXPECT_EQ(dwells, 5U);
}

TEST(CornerLoops, JoinTheContourWithoutACornerOfTheirOwn) {
  const CutPlan plan = planned("<path d=\"M10 10L70 22L64 60L31 40L12 55Z\"/>",
                               {.corner_loop_mm = 3.0, .corner_angle_deg = 30.0});
  ASSERT_EQ(plan.cuts.size(), 1U);
  ASSERT_EQ(figures_of(plan).corner_loops, 4U);
  const auto& strokes = plan.cuts.front().strokes;
  for (std::size_t i = 1; i < strokes.size(); ++i) {
    EXPECT_LT(drawing::distance(strokes[i - 1].to, strokes[i].from), 1.0e-9);
    const bool at_loop = strokes[i - 1].purpose == Purpose::kCornerLoop ||
                         strokes[i].purpose == Purpose::kCornerLoop;
    if (!at_loop) continue;
    EXPECT_GT(drawing::dot(tangent_at(strokes[i - 1], 1.0), tangent_at(strokes[i], 0.0)),
              1.0 - 1.0e-12);
  }
}

TEST(CornerLoops, AreMadeSmallerOrLeftOutWhereThereIsNoRoom) {
  constexpr const char* kNeighbours =
      "<rect x=\"10\" y=\"10\" width=\"20\" height=\"20\"/>"
      "<rect x=\"35\" y=\"2\" width=\"20\" height=\"36\"/>";
  const CutFigures smaller = figures_of(planned(kNeighbours, {.corner_loop_mm = 4.0}));
  EXPECT_EQ(smaller.corner_loops, 8U);
  const CutFigures free = figures_of(
      planned("<rect x=\"10\" y=\"10\" width=\"20\" height=\"20\"/>", {.corner_loop_mm = 4.0}));
  EXPECT_LT(smaller.corner_loop_mm, 2.0 * free.corner_loop_mm - 1.0);
  constexpr const char* kTight =
      "<rect x=\"10\" y=\"10\" width=\"20\" height=\"20\"/>"
      "<rect x=\"31\" y=\"2\" width=\"20\" height=\"36\"/>";
  const CutPlan tight = planned(kTight, {.corner_loop_mm = 4.0, .corner_dwell_s = 0.1});
  EXPECT_EQ(figures_of(tight).corner_loops, 6U);
  EXPECT_EQ(figures_of(tight).corner_dwells, 2U);
  std::size_t told = 0;
  for (const auto& warning : tight.warnings) {
    told += warning.reason.find("have no free space for their loops") != std::string::npos;
    EXPECT_TRUE(warning.place_mm.has_value());
  }
  EXPECT_EQ(told, 1U);
}

}  // namespace
}  // namespace sim::cut

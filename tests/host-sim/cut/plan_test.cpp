#include "host-sim/cut/plan.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using drawing::FaultKind;

constexpr const char* kPlate =
    "<rect x=\"10\" y=\"10\" width=\"60\" height=\"40\"/>"
    "<circle cx=\"25\" cy=\"30\" r=\"8\"/><circle cx=\"25\" cy=\"30\" r=\"4\"/>";

drawing::Drawing drawing_of(const std::string& content) {
  return drawing::read(drawing::svg_of(content));
}

std::vector<Outline> outlines_of(const drawing::Drawing& drawn) {
  std::vector<Outline> outlines;
  for (const auto& contour : drawn.contours) {
    outlines.push_back(outline_of(contour.shapes, 1.0e-4));
  }
  return outlines;
}

TEST(CutPlan, CutsWhatLiesInsideFirst) {
  const CutPlan plan = plan_of(drawing_of(kPlate));
  EXPECT_TRUE(plan.faults.empty());
  ASSERT_EQ(plan.cuts.size(), 3U);
  EXPECT_NEAR(plan.cuts[0].area_mm2, M_PI * (4 + kHalf) * (4 + kHalf), 1.0e-6);
  EXPECT_NEAR(plan.cuts[1].area_mm2, -M_PI * (8 - kHalf) * (8 - kHalf), 1.0e-6);
  EXPECT_TRUE(plan.cuts[1].is_hole);
  EXPECT_NEAR(plan.cuts[2].area_mm2,
              60.0 * 40.0 + 2.0 * (60.0 + 40.0) * kHalf + M_PI * kHalf * kHalf,
              1.0e-6);
}

/// A layout lists parts separately, and a small part may lie in the hole of another one.
TEST(CutPlan, CutsAPartThatLiesInTheHoleOfAnotherBeforeTheHole) {
  constexpr const char* kRing =
      R"({"partid": "ring", "paths": [[[0,0,1],[90,0,1],[0,0]], [[10,0,-1],[80,0,-1],[10,0]]]})";
  constexpr const char* kInner = R"({"partid": "inner", "paths": [[[60,0],[70,0],[65,8],[60,0]]]})";
  for (const std::string& layout :
       {fmt::format("[{},{}]", kRing, kInner), fmt::format("[{},{}]", kInner, kRing)}) {
    const drawing::Drawing drawn = drawing::read_drawing("layout.json", layout);
    ASSERT_EQ(drawn.contours.size(), 3U) << layout;
    const CutPlan plan = plan_of(drawn);
    EXPECT_TRUE(plan.faults.empty());
    ASSERT_EQ(plan.cuts.size(), 3U);
    EXPECT_NEAR(plan.cuts[0].area_mm2, 40.0, 12.0) << "the triangle";
    EXPECT_FALSE(plan.cuts[0].is_hole) << "it is none of its own part's";
    EXPECT_TRUE(plan.cuts[1].is_hole);
    EXPECT_EQ(plan.cuts[1].after, std::vector<std::size_t>{0});
    EXPECT_EQ(plan.cuts[2].after, std::vector<std::size_t>{1});
  }
}

TEST(CutPlan, NamesHolesThatWouldVanish) {
  const CutPlan plan =
      plan_of(drawing_of("<rect x=\"0\" y=\"0\" width=\"30\" height=\"30\"/>"
                         "<circle id=\"pin\" cx=\"10\" cy=\"10\" r=\"0.25\"/>"));
  ASSERT_EQ(plan.faults.size(), 1U);
  EXPECT_EQ(plan.faults[0].kind, FaultKind::kTooSmall);
  const std::string text = to_string(plan.faults[0], "part.svg");
  EXPECT_THAT(text,
              testing::HasSubstr("circle \"pin\" at 10.250 90.000: is narrower than the kerf"));
  EXPECT_EQ(plan.cuts.size(), 1U);
}

TEST(CutPlan, TellsOfSlotsThatTheBeamDoesNotReach) {
  const CutPlan plan = plan_of(drawing_of("<path d=\"M0 0H40V20H20.2V10H19.8V20H0Z\"/>"));
  ASSERT_EQ(plan.warnings.size(), 1U);
  EXPECT_THAT(plan.warnings[0].reason, testing::HasSubstr("too narrow here for the kerf of 0.600"));
  ASSERT_TRUE(plan.warnings[0].place_mm.has_value());
  EXPECT_NEAR(plan.warnings[0].place_mm->x(), 20.0, 0.21);
  EXPECT_NEAR(plan.warnings[0].place_mm->y(), 90.0, 0.01);
}

TEST(CutPlan, RefusesToCutOnePartOffAnother) {
  const CutPlan plan =
      plan_of(drawing_of("<rect x=\"0\" y=\"0\" width=\"10\" height=\"10\"/>"
                         "<rect x=\"10.4\" y=\"0\" width=\"10\" height=\"10\"/>"));
  ASSERT_EQ(plan.faults.size(), 2U);
  EXPECT_EQ(plan.faults[0].kind, FaultKind::kCrossing);
  EXPECT_THAT(plan.faults[0].reason, testing::HasSubstr("takes 0.200 mm off rect"));
}

/// The tip may come too near at any point of the cut, and by any small distance. In each case both
/// are cut as one part, and the user is informed.
TEST(CutPlan, FindsTheTipThatACutTouches) {
  for (int i = 0; i < 10; ++i) {
    const auto plan = [i](double gap_mm) {
      return plan_of(
          drawing_of(fmt::format("<rect x=\"0\" y=\"0\" width=\"10\" height=\"10\"/>"
                                 "<path d=\"M{} {} l3 5 h-0.4 z\"/>",
                                 5.0 + 0.013 * i,
                                 10.0 + gap_mm)));
    };
    const CutPlan near = plan(0.5997);
    EXPECT_THAT(near.faults, testing::IsEmpty()) << i;
    EXPECT_EQ(near.cuts.size(), 1U) << i;
    ASSERT_FALSE(near.warnings.empty()) << i;
    EXPECT_THAT(near.warnings[0].reason, testing::HasSubstr("nearer to an edge than the kerf"));
    EXPECT_NEAR(near.warnings[0].place_mm->x(), 5.0 + 0.013 * i, 0.1);
    const CutPlan apart = plan(0.6003);
    EXPECT_EQ(apart.cuts.size(), 2U) << i;
    EXPECT_THAT(apart.warnings, testing::IsEmpty()) << i;
  }
}

TEST(CutPlan, CutsOnTheLineWhatItsLayerSays) {
  const auto drawn =
      drawing_of("<path d=\"M0 0H5\"/><rect x=\"20\" y=\"0\" width=\"9\" height=\"9\"/>");
  const CutPlan plan = plan_of(drawn, {.side = Side::kOn});
  ASSERT_EQ(plan.cuts.size(), 2U);
  for (const Cut& cut : plan.cuts) {
    EXPECT_DOUBLE_EQ(length_of(cut.strokes), drawn.contours[cut.contour].closed ? 36.0 : 5.0);
  }
}

/// The last tab ends where the cut begins. No cut is made there that would free the part.
TEST(CutPlan, EndsAtATab) {
  for (const unsigned tabs : {1U, 3U}) {
    const LayerSettings settings{
        .overcut_mm = 1.0, .tab_mm = 0.5, .tabs = tabs, .start = StartAt::kTab};
    const CutPlan plan =
        plan_of(drawing_of("<rect x=\"10\" y=\"10\" width=\"20\" height=\"20\"/>"), settings);
    ASSERT_EQ(plan.cuts.size(), 1U);
    ASSERT_EQ(plan.warnings.size(), 1U);
    EXPECT_THAT(plan.warnings[0].reason, testing::HasSubstr("without overcut and lead-out"));
    const std::vector<Stroke>& strokes = plan.cuts[0].strokes;
    const auto first = std::ranges::find(strokes, Purpose::kContour, &Stroke::purpose);
    EXPECT_EQ(strokes.back().purpose, Purpose::kContour);
    EXPECT_NEAR(drawing::distance(first->from, strokes.back().to), 0.5 + kTestKerf, 0.2);
    EXPECT_EQ(std::ranges::count(strokes, Purpose::kOvercut, &Stroke::purpose), 0);
    double cut_mm = 0.0;
    double dark_mm = 0.0;
    for (const Stroke& stroke : strokes) {
      if (stroke.purpose == Purpose::kContour) cut_mm += length_of(stroke);
      if (stroke.purpose == Purpose::kTab) dark_mm += length_of(stroke);
    }
    EXPECT_NEAR(dark_mm, (tabs - 1) * (0.5 + kTestKerf), 1.0e-9);
    EXPECT_NEAR(cut_mm + tabs * (0.5 + kTestKerf), 80.0 + 2.0 * std::numbers::pi * kHalf, 1.0e-6);
  }
}

TEST(CutPlan, SaysWhichLayersAreCutLaterThanTheirRank) {
  const auto drawn = drawing_of(
      "<rect x=\"0\" y=\"0\" width=\"30\" height=\"30\" stroke=\"red\"/>"
      "<rect x=\"40\" y=\"0\" width=\"30\" height=\"30\" stroke=\"red\"/>"
      "<circle cx=\"9\" cy=\"9\" r=\"4\" stroke=\"blue\"/>"
      "<circle cx=\"50\" cy=\"9\" r=\"4\" stroke=\"blue\"/>");
  const auto plan_with = [&drawn](unsigned red, unsigned blue) {
    auto layers = layers_with(drawn, {});
    layers[0].settings.rank = red;
    layers[1].settings.rank = blue;
    return plan_cuts(drawn, layers);
  };
  EXPECT_TRUE(plan_with(1, 1).warnings.empty());
  EXPECT_TRUE(plan_with(2, 1).warnings.empty());
  const CutPlan plan = plan_with(0, 1);
  EXPECT_TRUE(plan.faults.empty());
  ASSERT_EQ(plan.warnings.size(), 1U);
  EXPECT_THAT(plan.warnings[0].reason, testing::HasSubstr("after the layer blue, of a later rank"));
  EXPECT_THAT(plan.warnings[0].reason, testing::HasSubstr("(and 1 more contour)"));
}

/// A frame that is not cut is not a part, and a contour in it is not a hole.
TEST(CutPlan, KnowsPartsInAFrameThatIsSkipped) {
  const auto drawn = drawing_of(
      "<rect x=\"0\" y=\"0\" width=\"90\" height=\"90\" stroke=\"red\"/>"
      "<rect x=\"20\" y=\"20\" width=\"9\" height=\"9\" stroke=\"blue\"/>");
  auto layers = layers_with(drawn, {});
  ASSERT_EQ(layers.size(), 2U);
  const bool first_is_red = drawn.layers[0].colour == "red";
  layers[first_is_red ? 0 : 1].settings.side = Side::kSkip;
  const CutPlan plan = plan_cuts(drawn, layers);
  ASSERT_EQ(plan.cuts.size(), 1U);
  EXPECT_FALSE(plan.cuts[0].is_hole);
  EXPECT_GT(plan.cuts[0].area_mm2, 81.0);
}

TEST(CutPlan, LeavesTabsOvercutsAndPierces) {
  LayerSettings settings{.overcut_mm = 1.5, .tab_mm = 0.4, .tabs = 4, .pierce_s = 0.5};
  settings.lead_out = {LeadKind::kLine, 3.0};
  const CutPlan plan = plan_of(drawing_of(kPlate), settings);
  for (const Cut& cut : plan.cuts) {
    double tabs = 0.0;
    double overcut = 0.0;
    int gaps = 0;
    Purpose last = Purpose::kLeadIn;
    for (const Stroke& stroke : cut.strokes) {
      if (stroke.purpose == Purpose::kTab) tabs += length_of(stroke);
      if (stroke.purpose == Purpose::kTab && last != Purpose::kTab) ++gaps;
      if (stroke.purpose == Purpose::kOvercut) overcut += length_of(stroke);
      last = stroke.purpose;
    }
    EXPECT_EQ(cut.strokes.front().purpose, Purpose::kPierce);
    EXPECT_EQ(cut.strokes.back().purpose, Purpose::kLeadOut);
    EXPECT_NEAR(overcut, 1.5, 1.0e-9);
    EXPECT_EQ(gaps, cut.is_hole ? 0 : 4);
    EXPECT_NEAR(tabs, cut.is_hole ? 0.0 : 4.0 * (0.4 + kTestKerf), 1.0e-9);
  }
}

/// Returns a sheet of plates at random positions, with holes, islands and rounded corners.
std::string random_plates(proof::Random& random) {
  std::string content;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double x = 33.0 * column + random.between(0.5, 3.0);
      const double y = 33.0 * row + random.between(0.5, 3.0);
      const double width = random.between(8.0, 28.0);
      const double height = random.between(8.0, 28.0);
      const double corner = random.chance(0.5) ? random.between(0.2, 3.9) : 0.0;
      content += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{}\"/>",
                             x,
                             y,
                             width,
                             height,
                             corner);
      if (random.chance(0.7)) {
        const double most = 0.5 * std::min(width, height) - 1.0;
        const double radius = random.between(0.4, most);
        content += fmt::format(
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>", x + 0.5 * width, y + 0.5 * height, radius);
      }
      if (random.chance(0.3)) {
        content += fmt::format("<path d=\"M{} {}h{}l{} {}z\"/>",
                               x + 1.0,
                               y + height - 1.2,
                               random.between(2.0, 6.0),
                               random.between(-3.0, -1.0),
                               random.between(-2.5, -1.5));
      }
    }
  }
  return content;
}

/// The beam, leads included, never comes nearer to a drawn line than half a kerf. Along each line
/// it is no farther away, except in corners that it cannot reach.
TEST(CutPlan, NeverCutsIntoAPart) {
  const proof::Trials trials{12};
  double nearest = 1.0;
  std::size_t strokes = 0;
  std::size_t without_leads = 0;
  std::size_t cuts = 0;
  std::size_t loops = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const auto drawn = drawing_of(random_plates(random));
    LayerSettings settings{.overcut_mm = random.chance(0.5) ? 1.0 : 0.0,
                           .tabs = random.chance(0.5) ? 3U : 0U,
                           .pierce_s = random.chance(0.5) ? 0.2 : 0.0};
    const auto kind = [&random] { return random.chance(0.5) ? LeadKind::kArc : LeadKind::kLine; };
    settings.lead_in = {kind(), random.between(0.5, 6.0)};
    settings.lead_out = {kind(), random.between(0.5, 6.0)};
    settings.corner_loop_mm = random.chance(0.6) ? random.between(0.1, 5.0) : 0.0;
    settings.corner_angle_deg = random.between(5.0, 120.0);
    const CutPlan plan = plan_of(drawn, settings);
    for (const auto& fault : plan.faults) {
      // In the random sheet, only holes and corners cross each other.
      EXPECT_TRUE(fault.kind == FaultKind::kCrossing || fault.kind == FaultKind::kTooSmall);
    }
    if (!plan.faults.empty() || drawn.has_errors()) continue;
    const auto outlines = outlines_of(drawn);
    for (const Cut& cut : plan.cuts) {
      ++cuts;
      if (cut.strokes.front().purpose == Purpose::kContour) ++without_leads;
      for (std::size_t i = 1; i < cut.strokes.size(); ++i) {
        EXPECT_LT(drawing::distance(cut.strokes[i - 1].to, cut.strokes[i].from), 1.0e-6);
      }
      for (const Stroke& stroke : cut.strokes) {
        ++strokes;
        if (stroke.purpose == Purpose::kCornerLoop) ++loops;
        for (const Place& place : places_along(stroke, 0.25)) {
          nearest = std::min(nearest, distance_to_all(outlines, place));
        }
      }
    }
    EXPECT_GT(nearest, kHalf - 2.0e-4);
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
      for (const std::size_t before : plan.cuts[i].after) EXPECT_LT(before, i);
    }
  }
  std::printf("%zu strokes of %zu cuts, %zu without leads: nearest %.6f mm, half a kerf %.6f\n",
              strokes,
              cuts,
              without_leads,
              nearest,
              kHalf);
  if (!trials.judges_shares()) return;
  EXPECT_GT(strokes, 400U);
  EXPECT_GT(loops, 20U);
  EXPECT_LT(without_leads, cuts / 4);
}

}  // namespace
}  // namespace sim::cut

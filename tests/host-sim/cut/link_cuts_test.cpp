#include "host-sim/cut/link_cuts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/cut/nesting.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

std::vector<Outline> drawn_outlines(const drawing::Drawing& drawn) {
  std::vector<Outline> outlines;
  for (const auto& contour : drawn.contours) {
    outlines.push_back(outline_of(contour.shapes, 1.0e-4));
  }
  return outlines;
}

TEST(LinkCuts, AreInTheWasteAndSaveTheirPierce) {
  const proof::Trials trials{20};
  std::size_t links = 0;
  std::size_t cuts = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const NestingSize size{.pitch_mm = random.between(20.0, 40.0),
                           .min_gap_mm = random.between(0.8, 6.0)};
    const auto drawn = drawing::read(nested_sheet(random, size));
    LayerSettings settings{.tabs = random.chance(0.3) ? 3U : 0U, .pierce_s = 1.0};
    if (random.chance(0.3)) settings.lead_in = {};
    if (random.chance(0.5)) settings.lead_out = {LeadKind::kArc, 1.0};
    const CutPlan before = plan_of(drawn, settings);
    CutPlan plan = before;
    link_cuts(plan, drawn, {.longest_mm = 30.0});
    const auto outlines = drawn_outlines(drawn);
    std::size_t pierces = 0;
    std::size_t linked = 0;
    ASSERT_EQ(plan.cuts.size(), before.cuts.size());
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
      const std::vector<Stroke>& strokes = plan.cuts[i].strokes;
      EXPECT_EQ(plan.cuts[i].contour, before.cuts[i].contour);
      for (const Stroke& stroke : strokes) {
        if (stroke.purpose == Purpose::kPierce) ++pierces;
      }
      if (strokes.front().purpose != Purpose::kLink) continue;
      ++linked;
      EXPECT_EQ(rapid_before(plan, i).front(), rapid_before(plan, i).back());
      EXPECT_EQ(strokes.size(), before.cuts[i].strokes.size() + 1);
      EXPECT_LE(length_of(strokes.front()), 30.0);
      for (const Place& place : places_along(strokes.front(), 0.05)) {
        EXPECT_GT(distance_to_all(outlines, place), kHalf - 2.0e-4);
      }
      for (const Cut& other : plan.cuts) {
        for (const Stroke& tab : other.strokes) {
          if (tab.purpose != Purpose::kTab) continue;
          for (const Place& place : places_along(strokes.front(), 0.1)) {
            ASSERT_GT(distance_to(tab, place), 1.4 * kTestKerf);
          }
        }
      }
    }
    EXPECT_EQ(linked, plan.safety.links);
    EXPECT_EQ(pierces + linked, plan.cuts.size());
    links += linked;
    cuts += plan.cuts.size();
  }
  std::printf("%zu of %zu cuts are linked\n", links, cuts);
  if (!trials.judges_shares()) return;
  EXPECT_GT(links, cuts / 20);
}

constexpr const char* kPair =
    "<rect x=\"10\" y=\"10\" width=\"20\" height=\"20\"/>"
    "<rect x=\"10\" y=\"36\" width=\"20\" height=\"20\"/>";

TEST(LinkCuts, AreNotMadeWhereTheyCostTimeOrAreTooLong) {
  const auto drawn = drawing::read(drawing::svg_of(kPair));
  const auto links_of = [&](double pierce_s, double longest_mm) {
    CutPlan plan = foreseen_plan_of(drawn, {.pierce_s = pierce_s});
    link_cuts(plan, drawn, {.longest_mm = longest_mm, .limits = {{1'600.0, 1'600.0}}});
    return plan.safety.links;
  };
  EXPECT_EQ(links_of(5.0, 60.0), 1U);
  EXPECT_EQ(links_of(0.0, 60.0), 0U) << "a rapid is faster";
  EXPECT_EQ(links_of(5.0, 3.0), 0U);
}

TEST(LinkCuts, LeaveTheBeamOn) {
  const auto drawn = drawing::read(drawing::svg_of(kPair));
  CutPlan plan = foreseen_plan_of(drawn, {.pierce_s = 5.0});
  link_cuts(plan, drawn, {.longest_mm = 60.0});
  ASSERT_EQ(plan.safety.links, 1U);
  const std::string program =
      program_of(plan, drawn, {.full_power_w = 2000.0}, cnc::gcode::PrintGrid{4}, {});
  const std::size_t second = program.find("(2: outer");
  EXPECT_THAT(program.substr(second, program.find("M5") - second),
              testing::Not(testing::HasSubstr("G0")));
}

}  // namespace
}  // namespace sim::cut

#include "host-sim/cut/recipe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "host-sim/cut/contour_size.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string refused_rule(const std::string& text) {
  try {
    static_cast<void>(parse_shop_rule(text, "--rule"));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "taken";
}

TEST(ShopRules, AConditionHasAKindComparisonsOrBoth) {
  const ShopRule rule = parse_shop_rule(
      " hole diameter<2.5 thickness and perimeter >= 3 mm: feed=60%, lead-in=line:1, power=900",
      "here");
  EXPECT_EQ(rule.kind, ContourKind::kHole);
  ASSERT_THAT(rule.comparisons, SizeIs(2));
  EXPECT_EQ(rule.comparisons[0].relation, Relation::kLess);
  EXPECT_TRUE(rule.comparisons[0].of_thickness);
  EXPECT_EQ(rule.comparisons[0].bound, 2.5);
  EXPECT_EQ(rule.comparisons[1].quantity, Quantity::kPerimeter);
  EXPECT_EQ(rule.comparisons[1].relation, Relation::kAtLeast);
  EXPECT_EQ(rule.comparisons[1].bound, 3.0);
  ASSERT_THAT(rule.changes, SizeIs(3));
  EXPECT_EQ(rule.changes[0].percent, 60.0);
  EXPECT_EQ(rule.changes[1].value, "line:1");
  EXPECT_EQ(parse_shop_rule("open: skip", "here").action, RuleAction::kSkip);
  EXPECT_EQ(parse_shop_rule("area < 20 mm2: skip", "here").comparisons.at(0).bound, 20.0);
  EXPECT_EQ(parse_shop_rule("hole diameter < 1 mm: mark, feed=900", "here").action,
            RuleAction::kMark);
  EXPECT_EQ(parse_shop_rule("diameter < thickness: mark", "here").comparisons.at(0).bound, 1.0);
}

TEST(ShopRules, WhatIsWrongIsToldByItsColumn) {
  EXPECT_THAT(
      refused_rule("holes: skip"),
      HasSubstr("--rule: column 1: `holes`: requires hole, outer, open, diameter, perimeter, "
                "area, thickness; did you mean hole?"));
  EXPECT_THAT(
      refused_rule("hole diametr < 3: skip"),
      HasSubstr("column 6: `diametr`: requires diameter, perimeter, area, thickness; did you "
                "mean diameter?"));
  EXPECT_THAT(refused_rule("hole diameter = 3: skip"), HasSubstr("column 15: requires `<`, `<=`"));
  EXPECT_THAT(refused_rule("hole diameter < big: skip"),
              HasSubstr("column 17: requires a number in mm"));
  EXPECT_THAT(refused_rule("hole diameter < -1: skip"), HasSubstr("column 17: out of range"));
  EXPECT_THAT(refused_rule("hole diameter < 3 mm2: skip"), HasSubstr("column 19: `mm2`: requires"));
  EXPECT_THAT(refused_rule("area < 3 mm: skip"),
              HasSubstr("column 10: `mm`: requires a number in mm2"));
  EXPECT_THAT(refused_rule("area < thickness: skip"),
              HasSubstr("column 8: requires a number in mm2"));
  EXPECT_THAT(refused_rule("area < 3"), HasSubstr("column 9: requires `:`"));
  EXPECT_THAT(refused_rule("area < 3 perimeter > 2: skip"), HasSubstr("`perimeter`"));
  EXPECT_THAT(refused_rule("area < 3: feed"), HasSubstr("column 11: requires `skip`, `mark` or"));
  EXPECT_THAT(refused_rule("area < 3: feed=fast"), HasSubstr("column 11: feed=fast: not a number"));
  EXPECT_THAT(refused_rule("area < 3: tabs=4, fed=9"),
              HasSubstr("column 19: fed: there is no such setting"));
  EXPECT_THAT(refused_rule("area < 3: tabs=50%"),
              HasSubstr("only feed and power can be a percentage"));
  EXPECT_THAT(refused_rule("area < 3: feed=0%"), HasSubstr("feed=0%: must be 0.1 to 1000 %"));
  EXPECT_THAT(refused_rule("area < 3: skip, feed=3"),
              HasSubstr("column 15: requires nothing after"));
  EXPECT_THAT(refused_rule("area < 3: mark feed=3"),
              HasSubstr("column 11: mark feed: there is no such"));
  EXPECT_THAT(refused_rule("open diameter < 3: skip"), HasSubstr("open contours have no diameter"));
  EXPECT_THAT(refused_rule(""), HasSubstr("column 1: requires hole"));
  EXPECT_THAT(refused_rule(": skip"), HasSubstr("column 1: requires hole"));
  EXPECT_THROW(static_cast<void>(read_shop_rules("# none\n\n", "rules")), std::invalid_argument);
  try {
    static_cast<void>(read_shop_rules("hole: skip\n\nhole: nothing\n", "rules"));
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("rules:3: column 7:"));
  }
}

TEST(ShopRules, NoTextCrashesTheReader) {
  const std::vector<std::string> words{
      "hole", "outer", "open", "diameter", "area", "<",   ">=", "3",    "thickness", ":", "skip",
      "mark", "feed",  "=",    "60%",      ",",    "and", " ",  "\xC3", "mm",        "-", "1e999"};
  for (const std::uint64_t seed : proof::Trials{20000}) {
    proof::Random random{seed};
    std::string text;
    for (std::size_t i = random.below(12); i > 0; --i)
      text += words[random.below(words.size())] + " ";
    const std::string told = refused_rule(text);
    EXPECT_TRUE(told == "taken" || told.starts_with("--rule: column ")) << text << ": " << told;
  }
}

/// Returns the diameter of the smallest circle through two or three of the points that contains all
/// points.
double smallest_by_trying(const std::vector<Place>& places) {
  double best = 1.0e9;
  const auto look = [&](const Place& centre, double radius) {
    for (const Place& place : places) {
      if (drawing::distance(centre, place) > radius * (1.0 + 1.0e-9)) return;
    }
    best = std::min(best, 2.0 * radius);
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      look(0.5 * (places[i] + places[j]), 0.5 * drawing::distance(places[i], places[j]));
      for (std::size_t k = 0; k < j; ++k) {
        const Place b = places[j] - places[i];
        const Place c = places[k] - places[i];
        const double twice = 2.0 * drawing::cross(b, c);
        if (std::abs(twice) < 1.0e-9) continue;
        const Place way{(c.y() * b.squaredNorm() - b.y() * c.squaredNorm()) / twice,
                        (b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) / twice};
        look(places[i] + way, way.norm());
      }
    }
  }
  return best;
}

TEST(ContourSize, TheSmallestCircleIsThatFoundByTryingAll) {
  for (const std::uint64_t seed : proof::Trials{400}) {
    proof::Random random{seed};
    std::vector<Place> places;
    const std::size_t count = 2 + random.below(14);
    const bool on_grid = random.chance(0.3);
    for (std::size_t i = 0; i < count; ++i) {
      const Place place{random.between(-50.0, 50.0), random.between(-50.0, 50.0)};
      places.push_back(on_grid ? Place{std::round(place.x() / 25.0), std::round(place.y() / 25.0)}
                               : place);
    }
    places.emplace_back(60.0, 0.0);
    const double expected = smallest_by_trying(places);
    EXPECT_NEAR(enclosing_diameter(places), expected, 1.0e-7 * expected) << seed;
  }
  EXPECT_EQ(enclosing_diameter({}), 0.0);
  EXPECT_EQ(enclosing_diameter({{3.0, 4.0}}), 0.0);
}

constexpr const char* kShopPart =
    "<rect id=\"plate\" x=\"10\" y=\"10\" width=\"80\" height=\"60\"/>"
    "<circle id=\"small\" cx=\"25\" cy=\"30\" r=\"0.4\"/><circle id=\"mid\" cx=\"40\" cy=\"30\" "
    "r=\"0.9\"/>"
    "<rect id=\"slot\" x=\"50\" y=\"20\" width=\"3\" height=\"4\"/>"
    "<circle id=\"big\" cx=\"70\" cy=\"30\" r=\"8\"/>";

/// Returns a condition with the requested power and feed, else 1800 W and 4000 mm/min, and a kerf
/// of 0.6 mm.
Condition chosen(const LayerSettings& settings) {
  Condition condition{{2000, 1'800'000, 4'000'000}, kTestKerf, 0.01};
  if (settings.feed_mm_min && *settings.feed_mm_min < 1000.0)
    throw std::invalid_argument("too slow");
  if (settings.feed_mm_min)
    condition.cut.speed_um_min = static_cast<std::uint32_t>(1000.0 * *settings.feed_mm_min);
  if (settings.power_w)
    condition.cut.power_mw = static_cast<std::uint32_t>(1000.0 * *settings.power_w);
  return condition;
}

struct Ruled {
  drawing::Drawing drawn;
  CutPlan plan;

  /// Returns the names of the contours to which a rule applied.
  [[nodiscard]] std::vector<std::string> names(std::size_t rule) const {
    std::vector<std::string> names;
    for (const std::size_t contour : plan.recipes.applied.at(rule).contours) {
      names.push_back(drawn.contours[contour].entity.name);
    }
    return names;
  }
  [[nodiscard]] const Cut* cut_of(const std::string& name) const {
    for (const Cut& cut : plan.cuts) {
      if (drawn.contours[cut.contour].entity.name == name) return &cut;
    }
    return nullptr;
  }
};

Ruled ruled_plan(const std::vector<std::string>& texts, const LayerSettings& settings = {}) {
  Ruled ruled{drawing::read(drawing::svg_of(kShopPart)), {}};
  std::vector<ShopRule> rules;
  for (const std::string& text : texts) rules.push_back(parse_shop_rule(text, "--rule"));
  const auto layers = layers_with(ruled.drawn, settings);
  Recipes recipes = apply_rules(rules, ruled.drawn, layers, 2.0, 0.1, chosen);
  ruled.plan = plan_cuts(ruled.drawn, layers, {}, WayBeside::kHere, std::move(recipes));
  return ruled;
}

TEST(Recipes, RulesChangeTheContoursOfWhichTheyHold) {
  const Ruled ruled =
      ruled_plan({"hole diameter < thickness: feed=60%, power=50%, lead-in=line:0.2",
                  "hole diameter < 1 mm: mark",
                  "outer perimeter > 200: tabs=4",
                  "area < 13: skip",
                  "area < 1: pierce=1"});
  EXPECT_THAT(ruled.names(0), ElementsAre("circle \"small\"", "circle \"mid\""));
  EXPECT_THAT(ruled.names(1), ElementsAre("circle \"small\""));
  EXPECT_THAT(ruled.names(2), ElementsAre("rect \"plate\""));
  EXPECT_THAT(ruled.names(3), ElementsAre("circle \"small\"", "circle \"mid\"", "rect \"slot\""));
  EXPECT_EQ(ruled.cut_of("circle \"small\""), nullptr);
  EXPECT_EQ(ruled.cut_of("rect \"slot\""), nullptr);
  EXPECT_NE(ruled.cut_of("circle \"big\""), nullptr);
  const Ruled kept = ruled_plan({"hole diameter < thickness: feed=60%, power=50%, lead-in=line:0.2",
                                 "hole diameter < 1 mm: mark"});
  const Cut* const mid = kept.cut_of("circle \"mid\"");
  ASSERT_NE(mid, nullptr);
  EXPECT_EQ(kept.plan.plan_of(*mid).condition.cut.speed_um_min, 2'400'000U);
  EXPECT_EQ(kept.plan.plan_of(*mid).condition.cut.power_mw, 900'000U);
  EXPECT_EQ(kept.plan.plan_of(*mid).settings.lead_in.kind, LeadKind::kLine);
  EXPECT_NEAR(std::abs(mid->area_mm2), M_PI * 0.6 * 0.6, 1.0e-6) << "beside its line";
  const Cut* const small = kept.cut_of("circle \"small\"");
  ASSERT_NE(small, nullptr);
  EXPECT_EQ(kept.plan.plan_of(*small).settings.side, Side::kMark);
  EXPECT_EQ(kept.plan.plan_of(*small).condition.cut.power_mw, 180'000U) << "a tenth of the layer's";
  EXPECT_TRUE(kept.plan.warnings.empty());
  const Cut* const big = kept.cut_of("circle \"big\"");
  ASSERT_NE(big, nullptr);
  EXPECT_EQ(kept.plan.plan_of(*big).condition.cut.speed_um_min, 4'000'000U);
}

TEST(Recipes, TheDiameterOfASlotIsThatOfTheCircleAroundIt) {
  EXPECT_THAT(ruled_plan({"hole diameter < 4.99: skip"}).names(0),
              ElementsAre("circle \"small\"", "circle \"mid\""));
  EXPECT_THAT(ruled_plan({"hole diameter <= 5.01: skip"}).names(0), SizeIs(3));
  EXPECT_THAT(ruled_plan({"diameter > 16.01: tabs=1"}).names(0), ElementsAre("rect \"plate\""));
}

TEST(Recipes, TheProgramAndTheReportGoByThem) {
  const Ruled ruled = ruled_plan({"hole diameter < 3: feed=50%"});
  const std::string program =
      program_of(ruled.plan, ruled.drawn, {.full_power_w = 1800.0}, cnc::gcode::PrintGrid{4}, {});
  EXPECT_THAT(program, HasSubstr("F2000"));
  EXPECT_THAT(program, HasSubstr("F4000"));
  EXPECT_THAT(
      lines_of(ruled.plan.recipes),
      ElementsAre("rule \"hole diameter < 3: feed=50%\": 2 contours; 1800 W at 2000 mm/min, "
                  "kerf 0.6000 mm"));
  EXPECT_THAT(lines_of(ruled_plan({"area > 9999: skip"}).plan.recipes),
              ElementsAre("rule \"area > 9999: skip\": 0 contours"));
}

TEST(Recipes, ARuleThatCannotBeMetIsNamed) {
  try {
    static_cast<void>(ruled_plan({"hole: feed=10%"}));
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "--rule: \"hole: feed=10%\": too slow");
  }
}

TEST(Recipes, SkippedLayersStaySkippedAndNoRuleChangesNothing) {
  EXPECT_THAT(ruled_plan({"hole: tabs=1"}, {.side = Side::kSkip}).names(0), IsEmpty());
  const Ruled plain = ruled_plan({});
  const Ruled vain = ruled_plan({"thickness > 5: skip"});
  ASSERT_EQ(plain.plan.cuts.size(), vain.plan.cuts.size());
  for (std::size_t i = 0; i < plain.plan.cuts.size(); ++i) {
    EXPECT_EQ(plain.plan.cuts[i].contour, vain.plan.cuts[i].contour);
    EXPECT_EQ(plain.plan.cuts[i].start(), vain.plan.cuts[i].start());
  }
}

}  // namespace
}  // namespace sim::cut

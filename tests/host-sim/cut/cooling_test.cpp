#include "host-sim/cut/cooling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "host-sim/cut/rapid_way.hpp"
#include "tests/host-sim/cut/nesting.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

/// Position of the beam at a time.
struct BurntPlace {
  Place place;
  double time_s;
};

/// Plays a plan with its own clock and records the points that the beam cut, 0.02 mm apart.
class CoolingOracle {
 public:
  CoolingOracle(const CutPlan& plan, const CoolingRules& rules) : plan_{plan}, rules_{rules} {}

  /// Returns the greatest time by which a pierce comes too early, s; 0 or less if all wait long
  /// enough.
  /// @param useless_s greatest excess of a wait over the required time
  double play(double& useless_s) {
    double early = -1.0e9;
    useless_s = 0.0;
    for (std::size_t i = 0; i < plan_.cuts.size(); ++i) {
      const Cut& cut = plan_.cuts[i];
      const std::vector<Place> way = rapid_before(plan_, i);
      for (std::size_t k = 1; k < way.size(); ++k) {
        const Place leg = way[k] - way[k - 1];
        now_s_ += std::max(std::abs(leg.x()) / rules_.limits.rate_mm_s[0],
                           std::abs(leg.y()) / rules_.limits.rate_mm_s[1]);
      }
      const double needed = needed_at(cut.start());
      if (needed > 0.0) early = std::max(early, needed - cut.wait_s);
      useless_s = std::max(useless_s, cut.wait_s - std::max(needed, 0.0));
      now_s_ += cut.wait_s;
      for (const Stroke& stroke : cut.strokes) burn(stroke, plan_.layers[cut.layer]);
    }
    return early;
  }

 private:
  [[nodiscard]] double needed_at(const Place& place) const {
    double needed = 0.0;
    for (auto burnt = burnt_.rbegin(); burnt != burnt_.rend(); ++burnt) {
      if (burnt->time_s + rules_.cool_s <= now_s_) break;
      if (drawing::distance(burnt->place, place) > rules_.distance_mm) continue;
      needed = std::max(needed, burnt->time_s + rules_.cool_s - now_s_);
    }
    return needed;
  }

  void burn(const Stroke& stroke, const LayerPlan& layer) {
    now_s_ += stroke.dwell_s;
    const double feed_mm_s = 1.0e-3 / 60.0 * layer.condition.cut.speed_um_min;
    double lasts = length_of(stroke) / feed_mm_s;
    if (stroke.purpose == Purpose::kPierce) lasts = std::max(lasts, layer.settings.pierce_s);
    if (stroke.purpose != Purpose::kTab) {
      const std::vector<Place> places = places_along(stroke, 0.02);
      for (std::size_t k = 0; k < places.size(); ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(places.size() - 1);
        burnt_.push_back({places[k], now_s_ + share * lasts});
      }
    }
    now_s_ += lasts;
  }

  const CutPlan& plan_;
  CoolingRules rules_;
  std::vector<BurntPlace> burnt_;
  double now_s_ = 0.0;
};

bool keeps_precedence(const CutPlan& plan) {
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    for (const std::size_t before : plan.cuts[i].after) {
      if (before >= i) return false;
    }
  }
  return true;
}

/// Returns pairs of contours; the first one of each must be cut before the second.
std::vector<std::pair<std::size_t, std::size_t>> wanted_pairs(const CutPlan& plan) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const Cut& cut : plan.cuts) {
    for (const std::size_t before : cut.after) {
      pairs.emplace_back(plan.cuts[before].contour, cut.contour);
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

TEST(Cooling, PiercesKeepOffFreshHeat) {
  const proof::Trials trials{20};
  double waits_s = 0.0;
  double waits_unordered_s = 0.0;
  std::size_t swaps = 0;
  std::size_t waits = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const NestingSize size{.pitch_mm = random.between(20.0, 40.0),
                           .min_gap_mm = random.between(0.8, 4.0)};
    const auto drawn = drawing::read(nested_sheet(random, size));
    CutPlan plan = plan_of(drawn, {.pierce_s = random.chance(0.5) ? 0.3 : 0.0});
    const CoolingRules rules{
        .cool_s = random.magnitude(0.1, 20.0),
        .distance_mm = random.magnitude(1.0, 20.0),
        .limits = {{random.between(80.0, 500.0), random.between(80.0, 500.0)}}};
    CutPlan as_ordered = plan;
    wait_for_cooling(as_ordered, rules);
    waits_unordered_s += as_ordered.safety.waits_s;
    const auto pairs = wanted_pairs(plan);
    const std::size_t count = plan.cuts.size();
    reorder_for_cooling(plan, rules);
    wait_for_cooling(plan, rules);
    ASSERT_EQ(plan.cuts.size(), count);
    EXPECT_TRUE(keeps_precedence(plan));
    EXPECT_EQ(wanted_pairs(plan), pairs);
    for (const CutPlan* each : {&plan, &as_ordered}) {
      double useless_s = 0.0;
      EXPECT_LE((CoolingOracle{*each, rules}.play(useless_s)), 1.0e-9);
      // The product rounds the distance of heat up to the next sixteenth of `distance_mm`.
      EXPECT_LE(useless_s, rules.cool_s);
    }
    waits_s += plan.safety.waits_s;
    waits += plan.safety.waits;
    swaps += plan.safety.cooling_swaps;
  }
  std::printf("%zu waits, %.1f s; %.1f s without %zu cuts that were moved\n",
              waits,
              waits_s,
              waits_unordered_s,
              swaps);
  if (!trials.judges_shares()) return;
  EXPECT_GT(swaps, 20U);
  EXPECT_LT(waits_s, 0.8 * waits_unordered_s);
}

TEST(Cooling, FarPartsDoNotWait) {
  const auto drawn =
      drawing::read(drawing::svg_of("<circle cx=\"10\" cy=\"10\" r=\"5\"/>"
                                    "<circle cx=\"90\" cy=\"90\" r=\"5\"/>"));
  CutPlan plan = plan_of(drawn);
  reorder_for_cooling(plan, {.cool_s = 60.0, .distance_mm = 20.0});
  wait_for_cooling(plan, {.cool_s = 60.0, .distance_mm = 20.0});
  EXPECT_EQ(plan.safety.waits, 0U);
  EXPECT_EQ(plan.safety.cooling_swaps, 0U);
}

TEST(Cooling, TheBeamIsOffWhileItWaits) {
  const auto drawn = drawing::read(drawing::svg_of(
      "<circle cx=\"10\" cy=\"10\" r=\"5\"/><circle cx=\"10\" cy=\"10\" r=\"2\"/>"));
  CutPlan plan = plan_of(drawn);
  wait_for_cooling(plan, {.cool_s = 10.0, .distance_mm = 5.0});
  ASSERT_GT(plan.cuts[1].wait_s, 9.0);
  ASSERT_LT(plan.cuts[1].wait_s, 10.0);
  const auto program = [&](bool follows_speed) {
    const Beam beam{.full_power_w = 2000.0, .follows_speed = follows_speed};
    return program_of(plan, drawn, beam, cnc::gcode::PrintGrid{4}, {});
  };
  EXPECT_THAT(program(true), testing::ContainsRegex("\nG0X[^\n]*\nM5\nG4 P9[.0-9]*\nM4\nG"));
  EXPECT_THAT(program(false), testing::ContainsRegex("\nG0X[^\n]*\nM5\nG4 P9[.0-9]*\nM3\nG"));
}

/// A cut does not move before a cut of an earlier layer: the user sets the order of the layers.
TEST(Cooling, KeepsTheOrderOfLayers) {
  const auto drawn =
      drawing::read(drawing::svg_of("<circle cx=\"10\" cy=\"10\" r=\"3\" stroke=\"red\"/>"
                                    "<circle cx=\"20\" cy=\"10\" r=\"3\" stroke=\"blue\"/>"
                                    "<circle cx=\"80\" cy=\"10\" r=\"3\" stroke=\"red\"/>"));
  CutPlan plan = plan_of(drawn);
  std::vector<std::size_t> contours;
  for (const Cut& cut : plan.cuts) contours.push_back(cut.contour);
  reorder_for_cooling(plan, {.cool_s = 100.0, .distance_mm = 20.0});
  for (std::size_t i = 0; i < contours.size(); ++i) EXPECT_EQ(plan.cuts[i].contour, contours[i]);
}

}  // namespace
}  // namespace sim::cut

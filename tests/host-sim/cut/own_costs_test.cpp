#include "host-sim/cut/own_costs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

constexpr double kSide = 40.0;

/// Returns a square that is cut on its line and rotated by `angle`, with beginnings at a corner and
/// in the middle of two edges.
UnbegunCut square_on_line(const Place& corner, double angle) {
  const Place along{kSide * std::cos(angle), kSide * std::sin(angle)};
  const Place aside{-along.y(), along.x()};
  const std::vector<Stroke> loop{{corner, corner + along},
                                 {corner + along, corner + along + aside},
                                 {corner + along + aside, corner + aside},
                                 {corner + aside, corner}};
  UnbegunCut cut{.path = MeasuredRow{loop}, .settings = {}};
  for (const double way : {kSide, 0.5 * kSide, 2.5 * kSide}) {
    const Place place = cut.path.place(way);
    cut.beginnings.push_back({.way_mm = way, .entry = place, .exit = place});
  }
  return cut;
}

const LayerPlan& steel_layer() {
  static const LayerPlan plan{{}, {{2000, 1'800'000, 2'400'000}, kTestKerf, 0.01}};
  return plan;
}

void find_costs(OwnCosts& costs, UnbegunCut& cut) {
  costs.find(cut, steel_layer(), [&cut](const Beginning& beginning) {
    return cut.path.begun_at(beginning.way_mm);
  });
}

/// Passing a corner at v takes (40 − v)² / (500 · 40) s longer than going straight on at 40 mm/s.
/// Its rounding takes additional time. These times are 0.068 s and 0.009 s at v = 3.1 mm/s, the
/// speed of a corner that is rounded within 8 µm. A beginning at the corner saves this time.
TEST(OwnCosts, OfACornerAreLessThanOfAnEdge) {
  const OrderWish machine{};
  OwnCosts costs{machine};
  UnbegunCut cut = square_on_line({10.0, 10.0}, 0.0);
  find_costs(costs, cut);
  ASSERT_EQ(cut.own_cost.size(), 3U);
  EXPECT_EQ(cut.own_cost[0], 0.0);
  EXPECT_NEAR(cut.own_cost[1], 50.0 * 0.077, 0.15);
  EXPECT_NEAR(cut.own_cost[2], cut.own_cost[1], 0.01);
}

TEST(OwnCosts, AreTheSameForCopiesAndBetweenBeginnings) {
  for (const std::uint64_t seed : proof::Trials{20}) {
    proof::Random random{seed};
    OrderWish machine{};
    if (random.chance(0.5)) machine.limits.jerk_mm_s3 = {20'000.0, 20'000.0};
    OwnCosts costs{machine};
    UnbegunCut first = square_on_line({10.0, 10.0}, 0.0);
    find_costs(costs, first);
    UnbegunCut copy = square_on_line({random.between(0.0, 300.0), random.between(0.0, 300.0)},
                                     0.5 * std::numbers::pi * static_cast<double>(random.below(4)));
    find_costs(costs, copy);
    ASSERT_EQ(copy.own_cost.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(copy.own_cost[i], first.own_cost[i], 0.02);
    // The order is: the listed beginning, the nearest one on the same edge, the most expensive one.
    EXPECT_EQ(own_cost_at(copy, copy.beginnings[0]), copy.own_cost[0]);
    EXPECT_EQ(own_cost_at(copy, {.way_mm = 0.3 * kSide}), copy.own_cost[1]);
    EXPECT_EQ(own_cost_at(copy, {.way_mm = 1.3 * kSide}),
              std::max(copy.own_cost[1], copy.own_cost[2]));
  }
}

/// On a diagonal both axes accelerate the machine, so a stop costs less.
TEST(OwnCosts, AreLessWhereBothAxesMove) {
  const OrderWish machine{};
  OwnCosts costs{machine};
  UnbegunCut upright = square_on_line({10.0, 10.0}, 0.0);
  UnbegunCut turned = square_on_line({100.0, 10.0}, 0.25 * std::numbers::pi);
  find_costs(costs, upright);
  find_costs(costs, turned);
  EXPECT_LT(turned.own_cost.at(1), 0.85 * upright.own_cost.at(1));
}

TEST(OwnCosts, AreNotFoundWhereThereIsNoChoice) {
  const OrderWish machine{};
  OwnCosts costs{machine};
  UnbegunCut cut = square_on_line({0.0, 0.0}, 0.0);
  cut.beginnings.resize(1);
  find_costs(costs, cut);
  EXPECT_TRUE(cut.own_cost.empty());
  EXPECT_EQ(own_cost_at(cut, cut.beginnings[0]), 0.0);
}

}  // namespace
}  // namespace sim::cut

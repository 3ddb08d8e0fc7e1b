#include "host-sim/cut/order_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numeric>

#include "host-sim/cut/beginning.hpp"
#include "host-sim/cut/group_order.hpp"
#include "host-sim/cut/part_units.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using order::OrderMethod;

/// Returns a small square with beginnings at some points of its edge, without leads.
UnbegunCut square_at(const Place& corner, double side, std::size_t beginnings) {
  const Place right{side, 0.0};
  const Place up{0.0, side};
  const std::vector<Stroke> loop{{corner, corner + right},
                                 {corner + right, corner + right + up},
                                 {corner + right + up, corner + up},
                                 {corner + up, corner}};
  UnbegunCut cut{.path = MeasuredRow{loop}, .settings = {}};
  cut.settings.lead_in = {};
  for (std::size_t i = 0; i < beginnings; ++i) {
    const double way =
        4.0 * side * (static_cast<double>(i) + 0.5) / static_cast<double>(beginnings);
    cut.beginnings.push_back(moved_to({}, cut.path, cut.settings, way));
  }
  return cut;
}

std::vector<UnbegunCut> squares_anywhere(proof::Random& random, std::size_t count) {
  std::vector<UnbegunCut> cuts;
  for (std::size_t i = 0; i < count; ++i) {
    const Place corner{random.between(0.0, 200.0), random.between(0.0, 200.0)};
    cuts.push_back(square_at(corner, random.between(1.0, 20.0), 1 + random.below(3)));
    // Exits are next to the entries, as with leads.
    for (Beginning& beginning : cuts.back().beginnings) {
      beginning.exit += Place{random.between(-2.0, 2.0), random.between(-2.0, 2.0)};
    }
    cuts.back().may_move = false;
    if (i > 0 && random.chance(0.4)) cuts.back().after.push_back(random.below(i));
  }
  return cuts;
}

double cost_of_order(const std::vector<OrderedCut>& order, const OrderWish& wish) {
  static const std::vector<UnbegunCut> plain(128,
                                             UnbegunCut{.path = MeasuredRow{{}}, .settings = {}});
  const RapidSum sum = rapids_of(order, plain, wish);
  return wish.cost == OrderCost::kTime ? sum.time_s : sum.length_mm;
}

/// Returns the cost of an order in the units of RapidCost, including the costs of the cuts
/// themselves.
double whole_cost_of(const std::vector<OrderedCut>& order,
                     const std::vector<UnbegunCut>& cuts,
                     const OrderWish& wish) {
  const bool is_time = wish.cost == OrderCost::kTime;
  const double unit = is_time ? std::ranges::min(wish.limits.rate_mm_s) : 1.0;
  double sum = unit * cost_of_order(order, wish);
  for (const OrderedCut& ordered : order) {
    const UnbegunCut& cut = cuts[ordered.cut];
    for (std::size_t i = 0; i < cut.own_cost.size(); ++i) {
      if (cut.beginnings[i].way_mm == ordered.beginning.way_mm) sum += cut.own_cost[i];
    }
  }
  return sum;
}

void make_own_costs(proof::Random& random, std::vector<UnbegunCut>& cuts) {
  for (UnbegunCut& cut : cuts) {
    for (std::size_t i = 0; i < cut.beginnings.size(); ++i) {
      cut.own_cost.push_back(random.between(0.0, 30.0));
    }
  }
}

bool keeps_precedence(const std::vector<OrderedCut>& order, const std::vector<UnbegunCut>& cuts) {
  std::vector<bool> is_done(cuts.size());
  for (const OrderedCut& ordered : order) {
    for (const std::size_t before : cuts[ordered.cut].after) {
      if (!is_done[before]) return false;
    }
    if (is_done[ordered.cut]) return false;
    is_done[ordered.cut] = true;
  }
  return order.size() == cuts.size();
}

bool is_any(const std::vector<OrderedCut>&) { return true; }

/// Tries every order that is allowed with every choice of beginnings.
class EveryOrder {
 public:
  using Allowed = std::function<bool(const std::vector<OrderedCut>&)>;

  EveryOrder(const std::vector<UnbegunCut>& cuts,
             const OrderWish& wish,
             const Allowed& allowed = is_any)
      : cuts_{cuts}, wish_{wish} {
    std::vector<std::size_t> order(cuts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
      std::vector<OrderedCut> tried;
      for (const std::size_t cut : order) tried.push_back({cut, {}});
      if (keeps_precedence(tried, cuts) && allowed(tried)) try_beginnings(tried, 0);
    } while (std::ranges::next_permutation(order).found);
  }
  [[nodiscard]] double least() const { return min_; }

 private:
  void try_beginnings(std::vector<OrderedCut>& order, std::size_t from) {
    if (from == order.size()) {
      min_ = std::min(min_, whole_cost_of(order, cuts_, wish_));
      return;
    }
    for (const Beginning& beginning : cuts_[order[from].cut].beginnings) {
      order[from].beginning = beginning;
      try_beginnings(order, from + 1);
    }
  }

  const std::vector<UnbegunCut>& cuts_;
  const OrderWish& wish_;
  double min_ = 1.0e9;
};

OrderWish wish_from(proof::Random& random) {
  OrderWish wish{.cost = random.chance(0.5) ? OrderCost::kTime : OrderCost::kLength};
  wish.from = {random.between(0.0, 50.0), random.between(0.0, 50.0)};
  wish.to = random.chance(0.5) ? wish.from : Place{random.between(0.0, 200.0), 0.0};
  if (random.chance(0.3)) wish.limits.jerk_mm_s3 = {8000.0, 8000.0};
  if (random.chance(0.3)) wish.limits.rate_mm_s = {200.0, 60.0};
  return wish;
}

TEST(OrderChoice, IsTheBestOfAllOrdersOfFewCuts) {
  for (const std::uint64_t seed : proof::Trials{25}) {
    proof::Random random{seed};
    std::vector<UnbegunCut> cuts = squares_anywhere(random, 1 + random.below(6));
    if (random.chance(0.5)) make_own_costs(random, cuts);
    OrderWish wish = wish_from(random);
    wish.method = random.chance(0.5) ? OrderMethod::kExact : OrderMethod::kOurs;
    const Clearance edges{1.0};
    const ChosenOrder chosen = choose_order(cuts, wish, edges);
    EXPECT_TRUE(keeps_precedence(chosen.cuts, cuts)) << "KERFLINE_SEED=" << seed;
    const double least = EveryOrder{cuts, wish}.least();
    EXPECT_NEAR(whole_cost_of(chosen.cuts, cuts, wish), least, 1.0e-9 * least)
        << "KERFLINE_SEED=" << seed;
    if (HasFailure()) return;
  }
}

TEST(OrderChoice, KeepsPrecedenceAndGroupsAndIsTheSameEachTime) {
  for (const std::uint64_t seed : proof::Trials{4}) {
    proof::Random random{seed};
    std::vector<UnbegunCut> cuts = squares_anywhere(random, 20 + random.below(60));
    OrderWish wish = wish_from(random);
    constexpr std::array kMethods{OrderMethod::kOurs, OrderMethod::kFile, OrderMethod::kNearest};
    wish.method = kMethods[random.below(3)];
    const bool has_ranks = random.chance(0.5);
    for (UnbegunCut& cut : cuts) {
      if (has_ranks && cut.after.empty()) cut.settings.rank = random.below(3);
    }
    const Clearance edges{1.0};
    const ChosenOrder chosen = choose_order(cuts, wish, edges);
    EXPECT_TRUE(keeps_precedence(chosen.cuts, cuts)) << "KERFLINE_SEED=" << seed;
    const ChosenOrder again = choose_order(cuts, wish, edges);
    unsigned rank = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      EXPECT_EQ(chosen.cuts[i].cut, again.cuts[i].cut);
      EXPECT_EQ(chosen.cuts[i].beginning.way_mm, again.cuts[i].beginning.way_mm);
      const UnbegunCut& cut = cuts[chosen.cuts[i].cut];
      if (!has_ranks || !cut.after.empty()) continue;
      EXPECT_GE(cut.settings.rank.value_or(0), rank) << "KERFLINE_SEED=" << seed;
      rank = cut.settings.rank.value_or(0);
    }
    if (HasFailure()) return;
  }
}

/// At any cost, an order is no worse than the nearest-neighbour order with the same beginnings.
TEST(OrderChoice, IsNoWorseThanTheNearestNeighbour) {
  for (const std::uint64_t seed : proof::Trials{4}) {
    proof::Random random{seed};
    const std::vector<UnbegunCut> cuts = squares_anywhere(random, 100);
    OrderWish wish = wish_from(random);
    const Clearance edges{1.0};
    const double ours = cost_of_order(choose_order(cuts, wish, edges).cuts, wish);
    wish.method = OrderMethod::kNearest;
    EXPECT_LE(ours, cost_of_order(choose_order(cuts, wish, edges).cuts, wish));
    EXPECT_LE(ours, cost_of_order(usual_order(cuts, wish, OrderMethod::kNearest), wish));
    if (HasFailure()) return;
  }
}

/// Moving the beginnings along their squares shortens the rapids by the returned length.
TEST(OrderChoice, RefinesBeginningsByWhatItSays) {
  for (const std::uint64_t seed : proof::Trials{100}) {
    proof::Random random{seed};
    std::vector<UnbegunCut> cuts = squares_anywhere(random, 10);
    for (UnbegunCut& cut : cuts) {
      cut.may_move = true;
      cut.beginnings = {moved_to({}, cut.path, cut.settings, 0.0)};
    }
    const OrderWish wish{.cost = OrderCost::kLength};
    std::vector<OrderedCut> order = usual_order(cuts, wish, OrderMethod::kFile);
    const double before = rapids_of(order, cuts, wish).length_mm;
    const Clearance edges{1.0};
    const double gain = refine_beginnings(order, cuts, RapidCost{}, {}, edges, 10);
    EXPECT_GT(gain, 0.0);
    EXPECT_NEAR(rapids_of(order, cuts, wish).length_mm, before - gain, 1.0e-6);
    for (const OrderedCut& ordered : order) {
      EXPECT_LT(distance_to(cuts[ordered.cut].path.strokes()[static_cast<std::size_t>(
                                ordered.beginning.way_mm / cuts[ordered.cut].path.length() * 4.0)],
                            ordered.beginning.entry),
                1.0e-9);
    }
    if (HasFailure()) return;
  }
}

/// Returns cuts of a few parts. Within a part, some cuts must come after others; between parts,
/// this is rare.
std::vector<UnbegunCut> parts_anywhere(proof::Random& random, std::size_t count) {
  std::vector<UnbegunCut> cuts = squares_anywhere(random, count);
  const std::size_t parts = 1 + count / 3;
  for (UnbegunCut& cut : cuts) {
    cut.part = random.below(parts);
    std::erase_if(cut.after, [&](std::size_t before) {
      return cuts[before].part != cut.part && random.chance(0.9);
    });
  }
  if (random.chance(0.5)) make_own_costs(random, cuts);
  return cuts;
}

/// Returns whether the cuts of each unit follow each other.
bool are_together(const std::vector<OrderedCut>& order, const PartUnits& units) {
  std::vector<std::size_t> unit_of(order.size());
  for (std::size_t i = 0; i < units.cuts.size(); ++i) {
    for (const std::size_t cut : units.cuts[i]) unit_of[cut] = i;
  }
  std::size_t changes = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (unit_of[order[i].cut] != unit_of[order[i - 1].cut]) ++changes;
  }
  return changes + 1 == units.cuts.size();
}

std::vector<std::size_t> all_of(const std::vector<UnbegunCut>& cuts) {
  std::vector<std::size_t> members(cuts.size());
  std::iota(members.begin(), members.end(), std::size_t{0});
  return members;
}

TEST(OrderChoice, KeepsThePartsTogetherThatAreToBe) {
  constexpr std::array kMethods{OrderMethod::kOurs, OrderMethod::kNearest, OrderMethod::kFile};
  for (const std::uint64_t seed : proof::Trials{6}) {
    proof::Random random{seed};
    const std::vector<UnbegunCut> cuts = parts_anywhere(random, 2 + random.below(20));
    OrderWish wish = wish_from(random);
    wish.grouping = Grouping::kPart;
    wish.method = kMethods[random.below(3)];
    const ChosenOrder chosen = choose_order(cuts, wish, Clearance{1.0});
    EXPECT_TRUE(keeps_precedence(chosen.cuts, cuts)) << "KERFLINE_SEED=" << seed;
    EXPECT_TRUE(are_together(chosen.cuts, units_of(cuts, all_of(cuts))))
        << "KERFLINE_SEED=" << seed;
    if (HasFailure()) return;
  }
}

/// Parts are ordered as units. The result is never worse than bringing their cuts together
/// afterwards, and near the best of all orders.
TEST(OrderChoice, OfPartsIsNoWorseThanBringingThemTogether) {
  double excess = 0.0;
  double count = 0.0;
  std::size_t better = 0;
  const proof::Trials trials{25};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const std::vector<UnbegunCut> cuts = parts_anywhere(random, 4 + random.below(3));
    OrderWish wish = wish_from(random);
    const std::vector<std::size_t> members = all_of(cuts);
    const PartUnits units = units_of(cuts, members);
    const RapidCost cost = wish.cost == OrderCost::kTime ? RapidCost{wish.limits} : RapidCost{};
    const GroupTask task{.from = wish.from, .to = wish.to, .seed = wish.seed};
    std::vector<OrderedCut> together = order_group(cuts, members, cost, task, {}).cuts;
    bring_together(together, units);
    choose_beginnings(together, cuts, cost, {wish.from, wish.to});
    const double afterwards = whole_cost_of(together, cuts, wish);
    wish.grouping = Grouping::kPart;
    const double ours = whole_cost_of(choose_order(cuts, wish, Clearance{1.0}).cuts, cuts, wish);
    EXPECT_LE(ours, afterwards * (1.0 + 1.0e-9)) << "KERFLINE_SEED=" << seed;
    if (ours < afterwards * (1.0 - 1.0e-9)) ++better;
    const auto allowed = [&](const std::vector<OrderedCut>& order) {
      return are_together(order, units);
    };
    const double least = EveryOrder{cuts, wish, allowed}.least();
    EXPECT_GE(ours, least * (1.0 - 1.0e-9)) << "KERFLINE_SEED=" << seed;
    excess += ours / least - 1.0;
    count += 1.0;
  }
  std::printf("parts: %.2f %% above the best order on average, %zu of %.0f better than before\n",
              100.0 * excess / count,
              better,
              count);
  if (!trials.judges_shares()) return;
  EXPECT_LT(excess / count, 0.08);
  EXPECT_GT(better, 0U);
}

/// A search that assumes equal costs in both directions of a stretch would find false gains without
/// end.
TEST(OrderChoice, EndsSoonForLinesThatCostMoreInOneDirection) {
  std::vector<UnbegunCut> cuts;
  for (std::size_t i = 0; i < 12; ++i) {
    const double x = 20.0 * static_cast<double>(i);
    UnbegunCut cut{
        .path = MeasuredRow{{{{x, 0.0}, {x + 15.0, 7.0}}}}, .is_open = true, .settings = {}};
    cut.beginnings = beginnings_of_line(cut.path);
    cut.own_cost = i % 2 == 0 ? std::vector{0.0, 1.0} : std::vector{1.0, 0.0};
    cut.may_move = false;
    cuts.push_back(std::move(cut));
  }
  cuts.push_back(square_at({50.0, 50.0}, 20.0, 16));
  cuts.push_back(square_at({0.0, 50.0}, 20.0, 16));
  const std::clock_t begin = std::clock();
  const ChosenOrder chosen = choose_order(cuts, {}, Clearance{1.0});
  EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
  EXPECT_EQ(chosen.cuts.size(), cuts.size());
}

/// Two parts are one unit if each of them has a cut that must come after a cut of the other.
TEST(PartUnits, JoinPartsThatWaitForEachOther) {
  proof::Random random{proof::test_seed()};
  std::vector<UnbegunCut> cuts = squares_anywhere(random, 5);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    cuts[i].after = {};
    cuts[i].part = i % 2;
  }
  cuts[4].part = 2;
  cuts[1].after = {0};
  cuts[2].after = {1};
  const PartUnits joined = units_of(cuts, all_of(cuts));
  ASSERT_EQ(joined.cuts.size(), 2U);
  EXPECT_EQ(joined.cuts[0], (std::vector<std::size_t>{4}));
  EXPECT_EQ(joined.cuts[1], (std::vector<std::size_t>{0, 1, 2, 3}));
  cuts[2].after = {};
  const PartUnits apart = units_of(cuts, all_of(cuts));
  ASSERT_EQ(apart.cuts.size(), 3U);
  EXPECT_EQ(apart.after[1], std::vector<std::size_t>{0});
}

TEST(OrderChoice, RefusesAProofOfManyCuts) {
  proof::Random random{1};
  const std::vector<UnbegunCut> cuts = squares_anywhere(random, 70);
  const Clearance edges{1.0};
  EXPECT_THROW(static_cast<void>(choose_order(cuts, {.method = OrderMethod::kExact}, edges)),
               std::invalid_argument);
}

}  // namespace
}  // namespace sim::cut

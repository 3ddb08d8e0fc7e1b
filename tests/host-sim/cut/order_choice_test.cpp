#include "host-sim/cut/order_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "host-sim/cut/group_order.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using order::OrderMethod;

/// Small squares with beginnings at some places of their edge, without leads.
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
    // Exits beside entries, as of leads.
    for (Beginning& beginning : cuts.back().beginnings) {
      beginning.exit += Place{random.between(-2.0, 2.0), random.between(-2.0, 2.0)};
    }
    cuts.back().may_move = false;
    if (i > 0 && random.chance(0.4)) cuts.back().after.push_back(random.below(i));
  }
  return cuts;
}

double cost_of_order(const std::vector<OrderedCut>& order, const OrderWish& wish) {
  const RapidSum sum = rapids_of(order, wish);
  return wish.cost == OrderCost::kTime ? sum.time_s : sum.length_mm;
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

/// Tries every order with every choice of beginnings.
class EveryOrder {
 public:
  EveryOrder(const std::vector<UnbegunCut>& cuts, const OrderWish& wish)
      : cuts_{cuts}, wish_{wish} {
    std::vector<std::size_t> order(cuts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
      std::vector<OrderedCut> tried;
      for (const std::size_t cut : order) tried.push_back({cut, {}});
      if (keeps_precedence(tried, cuts)) try_beginnings(tried, 0);
    } while (std::ranges::next_permutation(order).found);
  }
  [[nodiscard]] double least() const { return least_; }

 private:
  void try_beginnings(std::vector<OrderedCut>& order, std::size_t from) {
    if (from == order.size()) {
      least_ = std::min(least_, cost_of_order(order, wish_));
      return;
    }
    for (const Beginning& beginning : cuts_[order[from].cut].beginnings) {
      order[from].beginning = beginning;
      try_beginnings(order, from + 1);
    }
  }

  const std::vector<UnbegunCut>& cuts_;
  const OrderWish& wish_;
  double least_ = 1.0e9;
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
    const std::vector<UnbegunCut> cuts = squares_anywhere(random, 1 + random.below(6));
    OrderWish wish = wish_from(random);
    wish.method = random.chance(0.5) ? OrderMethod::kExact : OrderMethod::kOurs;
    const Clearance edges{1.0};
    const ChosenOrder chosen = choose_order(cuts, wish, edges);
    EXPECT_TRUE(keeps_precedence(chosen.cuts, cuts)) << "KERFLINE_SEED=" << seed;
    const double least = EveryOrder{cuts, wish}.least();
    EXPECT_NEAR(cost_of_order(chosen.cuts, wish), least, 1.0e-9 * least)
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

/// Whatever the cost, an order is no worse than that of the nearest with the same beginnings.
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

/// Beginnings that move along their squares make rapids shorter by what is returned.
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
    const double before = rapids_of(order, wish).length_mm;
    const Clearance edges{1.0};
    const double gain = refine_beginnings(order, cuts, RapidCost{}, {}, edges, 10);
    EXPECT_GT(gain, 0.0);
    EXPECT_NEAR(rapids_of(order, wish).length_mm, before - gain, 1.0e-6);
    for (const OrderedCut& ordered : order) {
      EXPECT_LT(distance_to(cuts[ordered.cut].path.strokes()[static_cast<std::size_t>(
                                ordered.beginning.way_mm / cuts[ordered.cut].path.length() * 4.0)],
                            ordered.beginning.entry),
                1.0e-9);
    }
    if (HasFailure()) return;
  }
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

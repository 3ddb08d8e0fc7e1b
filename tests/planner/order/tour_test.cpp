#include "planner/order/tour.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "planner/order/exchange.hpp"
#include "tests/planner/order/made_problem.hpp"
#include "tests/support/trials.hpp"

namespace {

using cnc::order::Exchange;
using cnc::order::Index;
using cnc::order::LooseEnd;
using cnc::order::Rearrangement;
using cnc::order::Tour;
using cnc::order::TourSizes;
using cnc::order::TourSpace;

/// Tests sets that are open lines, so that the direction of each set is visible in the tour.
class TourTest : public testing::Test {
 protected:
  struct Bench {
    explicit Bench(proof::Random& random, std::size_t sets)
        : made{random, {.sets = sets, .precedence = 0.0, .has_lines = true}},
          space{TourSizes{sets, 100}},
          tour{made.problem, *space} {
      std::vector<Index> order(sets);
      std::iota(order.begin(), order.end(), 0);
      for (std::size_t i = 1; i < sets; ++i) std::swap(order[i], order[i + random.below(sets - i)]);
      tour.assign(order, std::vector<Index>(made.first.begin(), made.first.end() - 1));
    }
    proof::MadeProblem made;
    proof::TestSpace<TourSpace> space;
    Tour tour;
  };

  /// Returns the candidates along the tour from home on, in the direction that does not reverse set
  /// 1.
  static std::vector<Index> canonical(const Bench& bench) {
    std::vector<Index> row;
    const Tour& tour = bench.tour;
    const bool backwards = tour.chosen(1) != bench.made.first[1];
    Index position = tour.position_of(0);
    for (Index i = 0; i < tour.size(); ++i) {
      const Index candidate = tour.chosen(tour.at(position));
      row.push_back(backwards ? bench.made.problem.reversal_of(candidate) : candidate);
      position = backwards ? tour.position_before(position) : tour.position_after(position);
    }
    return row;
  }
};

std::vector<Index> rows(const Tour& tour) {
  std::vector<Index> all{tour.order().begin(), tour.order().end()};
  all.insert(all.end(), tour.choices().begin(), tour.choices().end());
  return all;
}

/// Compares with the definition of each rearrangement, written with copies.
TEST_F(TourTest, RearrangesAsDefinedAndTakesItBack) {
  for (const std::uint64_t seed : proof::Trials{20'000}) {
    proof::Random random{seed};
    Bench bench{random, 2 + random.below(12)};
    Tour& tour = bench.tour;
    const std::vector<Index> before = rows(tour);
    const Index size = tour.size();
    const auto start = static_cast<Index>(random.below(size));
    const auto first = static_cast<Index>(random.below(size + 1));
    const auto second = static_cast<Index>(random.below(size - first + 1));
    const auto how = static_cast<Rearrangement>(random.below(4));
    std::vector<Index> b;
    std::vector<Index> c;
    const auto candidate = [&](Index step) { return tour.chosen(tour.at((start + step) % size)); };
    for (Index i = 0; i < first; ++i) b.push_back(candidate(i));
    for (Index i = 0; i < second; ++i) c.push_back(candidate(first + i));
    const auto backwards = [&](std::vector<Index>& row) {
      std::reverse(row.begin(), row.end());
      for (Index& one : row) one = bench.made.problem.reversal_of(one);
    };
    const bool both = how == Rearrangement::kReverseBoth;
    if (both || how == Rearrangement::kSwapReverseFirst) backwards(b);
    if (both || how == Rearrangement::kSwapReverseSecond) backwards(c);
    std::vector<Index> expected = both ? b : c;
    const std::vector<Index>& behind = both ? c : b;
    expected.insert(expected.end(), behind.begin(), behind.end());

    tour.rearrange(how, start, first, second);
    for (Index i = 0; i < expected.size(); ++i) EXPECT_EQ(candidate(i), expected[i]);
    for (Index set = 0; set < size; ++set) EXPECT_EQ(tour.at(tour.position_of(set)), set);
    tour.choose(0, bench.made.first[0]);
    tour.take_back_changes();
    EXPECT_EQ(rows(tour), before);
    if (HasFailure()) return;
  }
}

/// A free tour moves the shortest stretches, and has the same legs.
TEST_F(TourTest, AFreeTourChangesToTheSameTour) {
  for (const std::uint64_t seed : proof::Trials{20'000}) {
    proof::Random random{seed};
    proof::Random same{seed};
    const std::size_t sets = 4 + random.below(12);
    static_cast<void>(same.below(12));
    Bench fixed{random, sets};
    Bench free{same, sets};
    std::set<Index> cuts;
    while (cuts.size() < 3) cuts.insert(static_cast<Index>(random.below(sets)));
    Exchange exchange;
    std::copy(cuts.begin(), cuts.end(), exchange.cuts.begin());
    exchange.has_three = random.chance(0.8);
    exchange.how = static_cast<Rearrangement>(random.below(4));
    cnc::order::make_exchange(fixed.tour, exchange, false);
    cnc::order::make_exchange(free.tour, exchange, true);
    ASSERT_EQ(canonical(free), canonical(fixed));
  }
}

/// The rearrangement that find_rearrangement() returns has exactly the new legs.
TEST_F(TourTest, ThreeNewLegsAreFoundAgainInTheTour) {
  const proof::Trials trials{20'000};
  int found = 0;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    Bench bench{random, 4 + random.below(8)};
    Tour& tour = bench.tour;
    std::set<Index> positions;
    while (positions.size() < 3) positions.insert(static_cast<Index>(random.below(tour.size())));
    std::vector<cnc::order::CutLeg> cuts;
    for (const Index position : positions) {
      const LooseEnd exit{tour.at(position), false};
      const LooseEnd entry{tour.at(tour.position_after(position)), true};
      const bool turned = random.chance(0.5);
      cuts.push_back({turned ? entry : exit, turned ? exit : entry, position});
    }
    std::swap(cuts[0], cuts[random.below(3)]);
    std::swap(cuts[1], cuts[1 + random.below(2)]);
    const cnc::order::Legs legs{bench.made.problem, bench.made.cost(), tour};
    const double removed =
        legs.after(cuts[0].position) + legs.after(cuts[1].position) + legs.after(cuts[2].position);
    const bool joins_itself = cuts[0].other.set == cuts[1].one.set ||
                              cuts[1].other.set == cuts[2].one.set ||
                              cuts[2].other.set == cuts[0].one.set;
    Exchange exchange;
    if (joins_itself || !find_rearrangement(cuts[0], cuts[1], cuts[2], exchange)) continue;
    ++found;
    const double added = legs.join(cuts[0].other, cuts[1].one) +
                         legs.join(cuts[1].other, cuts[2].one) +
                         legs.join(cuts[2].other, cuts[0].one);
    const double before = legs.tour_cost();
    cnc::order::make_exchange(tour, exchange, false);
    ASSERT_NEAR(legs.tour_cost(), before - removed + added, 1.0e-9);
  }
  if (!trials.judges_shares()) return;
  EXPECT_GT(found, 0);
}

}  // namespace

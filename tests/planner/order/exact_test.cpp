#include "planner/order/exact.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "planner/order/entry_choice.hpp"
#include "tests/planner/order/made_problem.hpp"
#include "tests/support/trials.hpp"

namespace {

using cnc::order::Exact;
using cnc::order::ExactSizes;
using cnc::order::ExactSpace;
using cnc::order::ExactState;
using cnc::order::Index;
using proof::MadeProblem;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

ExactSizes sizes_of(const MadeProblem& made, std::size_t states) {
  return {made.problem.sets(), made.problem.candidates(), states, 4 * states};
}

TEST(ExactTest, ProvesTheOptimumThatTryingAllFinds) {
  for (const std::uint64_t seed : proof::Trials{1'000}) {
    proof::Random random{seed};
    const MadeProblem made{random, proof::random_kind(random, 7)};
    const double least = made.min_by_trying_all();
    const proof::TestSpace<ExactSpace> space{sizes_of(made, 2000)};
    // With a known tour the bounds prune the search. If that tour is optimal, the search finds no
    // better one.
    const double known = random.chance(0.3) ? kInfinite : least * random.between(1.0, 1.5);
    Exact exact{made.problem, made.cost(), made.set_of, *space, known};
    while (exact.run(1 + random.below(9)) == ExactState::kRunning) {
    }
    ASSERT_EQ(exact.state(), ExactState::kProven);
    EXPECT_NEAR(exact.best_cost(), least, 1.0e-8 * least);
    if (made.problem.candidates_of(0) == 1) {
      EXPECT_LE(exact.first_bound(), least * (1.0 + 1.0e-9));
    }
    if (exact.has_tour()) {
      EXPECT_TRUE(made.keeps_precedence(exact.order()));
      EXPECT_NEAR(made.cost_of(exact.order(), exact.chosen()), exact.best_cost(), 1.0e-9 * least);
    } else {
      EXPECT_NEAR(known, least, 1.0e-8 * least);
    }
    if (HasFailure()) return;
  }
}

TEST(ExactTest, ReportsThatItDoesNotFit) {
  proof::Random random{1};
  const MadeProblem made{random, {.sets = 12, .max_candidates = 2, .precedence = 0.0}};
  const proof::TestSpace<ExactSpace> space{sizes_of(made, 100)};
  Exact exact{made.problem, made.cost(), made.set_of, *space, kInfinite};
  EXPECT_EQ(exact.run(1'000'000), ExactState::kDoesNotFit);
  EXPECT_FALSE(exact.has_tour());
}

TEST(EntryChoiceTest, FindsTheBestCandidatesOfAnOrder) {
  for (const std::uint64_t seed : proof::Trials{2'000}) {
    proof::Random random{seed};
    const MadeProblem made{random, proof::random_kind(random, 7)};
    const auto [order, chosen] = made.nearest();
    const proof::TestSpace<cnc::order::TourSpace> tour_space{
        cnc::order::TourSizes{order.size(), 100}};
    cnc::order::Tour tour{made.problem, *tour_space};
    tour.assign(order, chosen);
    const proof::TestSpace<cnc::order::EntryChoiceSpace> space{
        cnc::order::EntryChoiceSizes{made.problem.candidates()}};
    cnc::order::EntryChoice choice{made.problem, made.cost(), tour, *space};
    const double before = made.cost_of(tour.order(), tour.choices());
    // First a window is optimized, whose gain must be the returned one, then the complete order.
    if (order.size() > 3) {
      const auto start = static_cast<Index>(random.below(order.size()));
      const auto length = static_cast<Index>(1 + random.below(order.size() - 2));
      const double gain = choice.improve(start, length, 0.0, [](Index) {});
      EXPECT_NEAR(made.cost_of(tour.order(), tour.choices()), before - gain, 1.0e-9 * before);
      EXPECT_GE(gain, 0.0);
    }
    static_cast<void>(choice.improve_all(0.0, [](Index) {}));
    const double least = made.min_of(order);
    EXPECT_NEAR(made.cost_of(tour.order(), tour.choices()), least, 1.0e-9 * least);
    if (HasFailure()) return;
  }
}

}  // namespace

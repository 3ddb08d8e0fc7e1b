#include "planner/order/search.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/planner/order/made_problem.hpp"
#include "tests/support/trials.hpp"

namespace {

using cnc::order::Index;
using cnc::order::MatrixCost;
using cnc::order::Search;
using cnc::order::SearchSizes;
using cnc::order::SearchSpace;
using proof::MadeProblem;

struct Found {
  std::vector<Index> order;
  std::vector<Index> chosen;
  double cost = 0.0;

  bool operator==(const Found&) const = default;
};

/// Runs the search in parts, whose lengths must not matter.
Found found(const MadeProblem& made, std::uint64_t seed, const std::vector<std::uint64_t>& parts) {
  const proof::TestSpace<SearchSpace> space{
      SearchSizes{made.problem.sets(), made.problem.candidates()}};
  const auto [order, chosen] = made.nearest();
  Search<MatrixCost> search{
      made.problem, made.cost(), made.neighbours, *space, {order, chosen}, seed};
  for (const std::uint64_t steps : parts) search.run(steps, 0.5);
  Found result;
  result.cost = search.best_cost();
  result.order.assign(search.best_order().begin(), search.best_order().end());
  result.chosen.assign(search.best_chosen().begin(), search.best_chosen().end());
  return result;
}

/// For any problem and any number of steps, the result is a permutation that begins at home and
/// keeps the precedence. Its cost must be the returned one, and at most that of the start.
TEST(SearchTest, KeepsPrecedenceAndItsBooks) {
  for (const std::uint64_t seed : proof::Trials{2'000}) {
    proof::Random random{seed};
    const MadeProblem made{random, proof::random_kind(random, 40)};
    const Found result = found(made, seed, {random.below(400)});
    std::vector<Index> sorted = result.order;
    std::sort(sorted.begin(), sorted.end());
    for (Index i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
    EXPECT_EQ(result.order.front(), 0U);
    EXPECT_TRUE(made.keeps_precedence(result.order));
    for (Index set = 0; set < made.problem.sets(); ++set) {
      EXPECT_EQ(made.set_of[result.chosen[set]], set);
    }
    const double cost = made.cost_of(result.order, result.chosen);
    EXPECT_NEAR(result.cost, cost, 1.0e-9 * cost + 1.0e-9);
    const auto [order, chosen] = made.nearest();
    EXPECT_LE(cost, made.cost_of(order, chosen) * (1.0 + 1.0e-12) + 1.0e-9);
    if (HasFailure()) return;
  }
}

TEST(SearchTest, IsTheSameHoweverItsStepsAreDivided) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    const MadeProblem made{random, proof::random_kind(random, 40)};
    const Found whole = found(made, seed, {600});
    ASSERT_EQ(found(made, seed, {1, 99, 200, 300}), whole);
  }
}

/// Compares with all tours. For a few sets, the search must always find the optimum.
TEST(SearchTest, FindsTheOptimumOfSmallProblems) {
  for (const std::uint64_t seed : proof::Trials{500, proof::Trials::Range::kFixed}) {
    proof::Random random{seed};
    proof::ProblemKind kind = proof::random_kind(random, 7);
    kind.forbidden = 0.0;
    const MadeProblem made{random, kind};
    const double least = made.min_by_trying_all();
    EXPECT_NEAR(found(made, seed, {2000}).cost, least, 1.0e-9 * least)
        << kind.sets << " sets, symmetric " << kind.is_symmetric << ", lines " << kind.has_lines
        << made.problem.is_free() << made.problem.candidates_of(0);
  }
}

/// The points are uniform. The result must be within a few percent of the limit for long tours,
/// which 2-opt alone does not reach.
TEST(SearchTest, ComesNearToTheOptimumOfUniformPoints) {
  constexpr Index kPoints = 2000;
  constexpr Index kWidth = 8;
  proof::Random random{7};
  std::vector<cnc::order::Place> places(kPoints);
  for (auto& place : places) place = {random.between(0.0, 1.0), random.between(0.0, 1.0)};
  std::vector<Index> first(kPoints + 1);
  std::iota(first.begin(), first.end(), 0);
  const cnc::order::Problem problem{first, {}, {}, true, true};
  const proof::TestSpace<cnc::order::PlaceTreeSpace> tree_space{
      cnc::order::PlaceTreeSizes{kPoints}};
  const cnc::order::PlaceTree tree{places, *tree_space, true};
  std::vector<Index> lists(std::size_t{kPoints} * kWidth);
  const cnc::order::CandidatePlaces candidates{places, places};
  const auto neighbours =
      cnc::order::find_neighbours(problem, candidates, tree, first, kWidth, lists);
  const proof::TestSpace<SearchSpace> space{SearchSizes{kPoints, kPoints}};
  const std::span<const Index> as_numbered = std::span{first}.first(kPoints);
  const cnc::order::PlaneCost cost{candidates};
  Search<cnc::order::PlaneCost> search{
      problem, cost, neighbours, *space, {as_numbered, as_numbered}, 1};
  while (!search.is_locally_best()) search.run(100, 0.0);
  const double limit = 0.7124 * std::sqrt(double{kPoints});
  EXPECT_LT(search.best_cost(), 1.09 * limit);
  for (int i = 0; i < 100; ++i) search.run(200, 1.0 - i / 100.0);
  EXPECT_LT(search.best_cost(), 1.05 * limit);
}

}  // namespace

#include "planner/order/annealing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/planner/order/made_problem.hpp"
#include "tests/support/trials.hpp"

namespace {

using cnc::order::Annealing;
using cnc::order::AnnealingSizes;
using cnc::order::AnnealingSpace;
using cnc::order::Index;
using proof::MadeProblem;
using PlainAnnealing = Annealing<cnc::order::MatrixCost>;

constexpr double kUnit = 100.0;  // Side of the square of MadeProblem.

TEST(AnnealingTest, ItsDecayIsTheExponentialWithinTheStatedError) {
  for (int i = 0; i <= 400'000; ++i) {
    const double x = i * 1.0e-4;
    const long double exact = std::exp(-static_cast<long double>(x));
    ASSERT_LE(std::abs(static_cast<double>(cnc::order::wide_decay(x) / exact - 1.0L)),
              cnc::order::kWideDecayError)
        << x;
  }
  EXPECT_EQ(cnc::order::wide_decay(40.1), 0.0);
}

/// At any time, the result is a permutation that begins at home and keeps the precedence.
TEST(AnnealingTest, KeepsPrecedenceAndHome) {
  for (const std::uint64_t seed : proof::Trials{1'000}) {
    proof::Random random{seed};
    const MadeProblem made{random, proof::random_kind(random, 20)};
    const proof::TestSpace<AnnealingSpace> space{AnnealingSizes{made.problem.sets()}};
    PlainAnnealing annealing{made.problem, made.cost(), *space, kUnit, seed};
    for (int part = 0; part < 5; ++part) {
      std::vector<Index> sorted{annealing.order().begin(), annealing.order().end()};
      std::sort(sorted.begin(), sorted.end());
      for (Index i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
      EXPECT_EQ(annealing.order().front(), 0U);
      EXPECT_TRUE(made.keeps_precedence(annealing.order()));
      for (Index set = 0; set < made.problem.sets(); ++set) {
        EXPECT_EQ(made.set_of[annealing.chosen()[set]], set);
      }
      annealing.run(random.below(300));
    }
    if (HasFailure()) return;
  }
}

TEST(AnnealingTest, CoolsAsThePaperSays) {
  proof::Random random{3};
  const MadeProblem made{random, {.sets = 30, .max_candidates = 3, .precedence = 0.0}};
  const proof::TestSpace<AnnealingSpace> space{AnnealingSizes{30}};
  PlainAnnealing annealing{made.problem, made.cost(), *space, kUnit, 1};
  while (annealing.run(100)) {
  }
  const auto course = annealing.course();
  ASSERT_EQ(course.size(), 70U);  // 1.5 · 0.9^n falls below 0.001 after 70.
  for (std::size_t i = 0; i < course.size(); ++i) {
    EXPECT_NEAR(course[i].temperature, 1.5 * std::pow(0.9, static_cast<double>(i)), 1.0e-9);
    EXPECT_TRUE(course[i].tries == 3000 || course[i].accepted >= 300) << i;
    EXPECT_LE(course[i].tries, 3000U);
  }
  EXPECT_LT(annealing.cost(), 0.7 * course.front().cost);
}

/// The paper's scheme reaches similar results on 35 points: mostly the optimum.
TEST(AnnealingTest, OftenFindsTheOptimumOfThirtyFivePoints) {
  double sum = 0.0;
  double least = 1.0e300;
  constexpr int kRuns = 20;
  proof::Random random{35};
  const MadeProblem made{random, {.sets = 35, .max_candidates = 1, .precedence = 0.0}};
  for (int seed = 0; seed < kRuns; ++seed) {
    const proof::TestSpace<AnnealingSpace> space{AnnealingSizes{35}};
    PlainAnnealing annealing{
        made.problem, made.cost(), *space, kUnit, static_cast<std::uint64_t>(seed)};
    while (annealing.run(1000)) {
    }
    sum += annealing.cost();
    least = std::min(least, annealing.cost());
  }
  EXPECT_LT(sum / kRuns, 1.02 * least);
}

}  // namespace

#include "planner/pocket/clearing.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "tests/planner/pocket/pocket_oracle.hpp"
#include "tests/planner/pocket/random_pocket.hpp"
#include "tests/support/trials.hpp"

namespace cnc::pocket {
namespace {

constexpr ClearingOptions<double> kPaperTool{.tool_radius = 5.0, .stepover = 10.0};

/// Returns the oracle for the bench's pocket and the first `passes` passes.
PocketOracle oracle_of(PocketBench& bench, double radius, std::size_t passes) {
  auto wall = std::make_unique<contour::BoundedContour<double, 4096, 256>>();
  auto space = std::make_unique<contour::BoundedOffsetSpace<double, 4096, 16384>>();
  const auto locus =
      contour::offset<double>(bench.pocket(), -radius, space->space(), wall->writer());
  EXPECT_TRUE(locus.ok());
  PocketOracle oracle{bench.pocket(), locus.value(), radius};
  for (std::size_t i = 0; i < passes; ++i) oracle.add_pass(bench.passes().loops(i));
  return oracle;
}

TEST(Clearing, OfThePapersPocketTakesEightPassesAndLeavesNothing) {
  PocketBench bench;
  const auto count = bench.paper().clear(kPaperTool);
  ASSERT_TRUE(count.ok());
  ASSERT_EQ(count.value(), 8U);
  constexpr double kPaper[] = {
      5.0, 11.865536, 19.057985, 26.514101, 34.189170, 42.049602, 50.069204, 58.227025};
  // The paper uses the angle of the tangents. As the arc bends away from it, a greater distance is
  // possible.
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_GE(bench.passes().note(i).distance, kPaper[i] - 1.0e-5) << i;
    EXPECT_LE(bench.passes().note(i).distance, kPaper[i] + 1.2) << i;
  }
  const PocketOracle oracle = oracle_of(bench, 5.0, 8);
  proof::Random random{1};
  EXPECT_LE(oracle.farthest(random, 20'000), 5.0 + 1.0e-6);
  EXPECT_GE(oracle.min_clearance(), 5.0 - 1.0e-9);
  EXPECT_NEAR(oracle.length(), 2099.4, 1.0);
}

TEST(Clearing, WithRoundCornersLeavesNothingEither) {
  PocketBench bench;
  auto options = kPaperTool;
  options.corner_radius = 0.5;
  const auto count = bench.paper().clear(options);
  ASSERT_TRUE(count.ok());
  const PocketOracle oracle = oracle_of(bench, 5.0, count.value());
  proof::Random random{1};
  EXPECT_LE(oracle.farthest(random, 20'000), 5.0 + 1.0e-6);
  EXPECT_EQ(count.value(), 8U);
  EXPECT_NEAR(oracle.length(), 2146.7, 1.0);
}

// The passes are made for a tool that is a hundredth larger. The oracle must find the material that
// remains.
TEST(Clearing, OracleFindsWhatASmallerToolLeaves) {
  PocketBench bench;
  const auto count = bench.paper().clear(kPaperTool);
  ASSERT_TRUE(count.ok());
  const PocketOracle oracle = oracle_of(bench, 4.95, count.value());
  proof::Random random{1};
  EXPECT_GT(oracle.farthest(random, 20'000), 4.99);
}

TEST(Clearing, OfASquareStepsByTheFormula) {
  PocketBench bench;
  const auto count = bench.rectangle(0, 0, 100, 100).clear({.tool_radius = 5, .stepover = 10});
  ASSERT_TRUE(count.ok());
  const double step = 5.0 * (1.0 + std::sqrt(0.5));
  for (std::uint32_t i = 0; i + 1 < count.value(); ++i) {
    EXPECT_NEAR(bench.passes().note(i).distance, 5.0 + step * i, 1.0e-5) << i;
    EXPECT_EQ(bench.passes().note(i).parent, i == 0 ? contour::kNone : i - 1);
  }
}

TEST(Clearing, OfACircleStepsByTheDiameter) {
  PocketBench bench;
  const auto count = bench.circle(0, 0, 55).clear({.tool_radius = 5, .stepover = 10});
  ASSERT_TRUE(count.ok());
  EXPECT_EQ(count.value(), 6U);
  EXPECT_NEAR(bench.passes().note(4).distance, 45.0, 1.0e-4);
}

TEST(Clearing, OfAPocketOfTheToolsWidthIsNone) {
  PocketBench bench;
  const auto count = bench.rectangle(0, 0, 100, 10).clear({.tool_radius = 5, .stepover = 10});
  ASSERT_TRUE(count.ok());
  EXPECT_EQ(count.value(), 0U);
}

TEST(Clearing, KeepsToTheStepover) {
  for (const double stepover : {1.0, 4.0, 4.99, 5.0, 6.0, 8.0}) {
    PocketBench bench;
    const auto count =
        bench.paper().clear({.tool_radius = 5, .corner_radius = 1.0, .stepover = stepover});
    ASSERT_TRUE(count.ok());
    for (std::uint32_t i = 1; i < count.value(); ++i) {
      const PassNote<double>& note = bench.passes().note(i);
      const double step = note.distance - bench.passes().note(note.parent).distance;
      EXPECT_LE(step, stepover + 1.0e-9);
      EXPECT_GE(step, std::min(stepover, 4.0) - 1.0e-9);
    }
    const PocketOracle oracle = oracle_of(bench, 5.0, count.value());
    proof::Random random{1};
    EXPECT_LE(oracle.farthest(random, 2000), 5.0 + 1.0e-6);
  }
}

TEST(Clearing, RefusesOptionsOutOfRange) {
  PocketBench bench;
  bench.paper();
  for (const ClearingOptions<double> bad : {ClearingOptions<double>{0.0, 0.0, 1.0},
                                            ClearingOptions<double>{5.0, -0.1, 1.0},
                                            ClearingOptions<double>{5.0, 2.0, 1.0},
                                            ClearingOptions<double>{5.0, 0.0, 0.0},
                                            ClearingOptions<double>{std::nan(""), 0.0, 1.0},
                                            ClearingOptions<double>{5.0, 0.0, std::nan("")}}) {
    const auto count = bench.clear(bad);
    ASSERT_FALSE(count.ok());
    EXPECT_EQ(count.error().fault, ClearingFault::kOptionOutOfRange);
  }
}

TEST(Clearing, OfAStrayIslandReportsCrossingLoops) {
  PocketBench bench;
  bench.rectangle(0, 0, 30, 30).round_island(100, 100, 20);
  const auto count = bench.clear({.tool_radius = 2, .stepover = 4});
  ASSERT_TRUE(count.ok() || count.error().fault == ClearingFault::kLoopsCross);
}

std::string complaint_about(std::uint64_t seed, double& worst) {
  proof::Random random{seed};
  PocketBench bench;
  const double radius = add_random_pocket(bench, random);
  ClearingOptions<double> options{.tool_radius = radius, .stepover = 2.0 * radius};
  if (random.chance(0.5)) options.corner_radius = random.between(0.0, 0.33) * radius;
  if (random.chance(0.2)) options.stepover = random.between(0.2, 2.0) * radius;
  const auto count = bench.clear(options);
  if (!count.ok()) {
    return "fault " + std::to_string(static_cast<int>(count.error().fault)) + ", offset " +
           std::to_string(static_cast<int>(count.error().offset.fault));
  }
  const PocketOracle oracle = oracle_of(bench, radius, count.value());
  const double far = oracle.farthest(random, 300) - radius;
  worst = std::max(worst, far);
  if (far > 1.0e-6) return "leaves " + std::to_string(far) + " mm";
  if (oracle.min_clearance() < radius - 1.0e-9) {
    return "gouges by " + std::to_string(radius - oracle.min_clearance());
  }
  return {};
}

TEST(Clearing, OfRandomPocketsReachesAllOfTheStock) {
  double worst = -1.0;
  for (const std::uint64_t seed : proof::Trials{300}) {
    EXPECT_EQ(complaint_about(seed, worst), "") << "KERFLINE_SEED=" << seed;
  }
  std::printf("at most %.2g mm beyond the radius\n", worst);
}

}  // namespace
}  // namespace cnc::pocket

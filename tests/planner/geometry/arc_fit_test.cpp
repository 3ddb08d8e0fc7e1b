#include "planner/geometry/arc_fit.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/planner/geometry/chain_check.hpp"
#include "tests/planner/geometry/random_spline.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

using exact::chain_of;
using exact::ChainCheck;

struct Summary {
  double deviation = 0.0;  ///< Greatest deviation, as a fraction of the tolerance.
  double smooth = 0.0;     ///< Greatest kink, as a fraction of the documented one.
  std::size_t curves = 0;
  std::size_t arcs = 0;
  std::size_t corners = 0;
};

void check(const Spline& spline, double tolerance, Summary& summary) {
  const Position start{Coordinate{123'456'789}, Coordinate{-987'654'321}, Coordinate{7}};
  const auto chain = chain_of(spline, start, tolerance);
  ASSERT_FALSE(chain.empty());
  const PlanePlace& last = spline.point(spline.size() - 1).place;
  EXPECT_EQ(chain.front().start, start);
  EXPECT_EQ(chain.back().end[0] - start[0], Coordinate{last.x});
  EXPECT_EQ(chain.back().end[1] - start[1], Coordinate{last.y});
  EXPECT_EQ(chain.back().end[2], start[2]);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    EXPECT_EQ(chain[i].plane, Plane::kXY);
    EXPECT_LE(std::abs(chain[i].bulge), 1.0F);
    EXPECT_EQ(chain[i].start, i == 0 ? start : chain[i - 1].end);
  }
  const ChainCheck held{spline, chain};
  EXPECT_LE(held.deviation(), tolerance) << chain.size() << " arcs";
  const auto corners = held.corners(3.0 * tolerance);
  EXPECT_LE(corners.unfounded, 0.0) << chain.size() << " arcs, " << corners.count << " corners";
  summary.deviation = std::max(summary.deviation, held.deviation() / tolerance);
  summary.smooth = std::max(summary.smooth, corners.smooth);
  summary.corners += corners.count;
  summary.arcs += chain.size();
  ++summary.curves;
}

void print(const char* name, const Summary& summary) {
  std::printf(
      "%s: %zu curves, %zu arcs, greatest deviation %.4f of the tolerance, %zu corners, "
      "greatest kink %.3f of the promise\n",
      name,
      summary.curves,
      summary.arcs,
      summary.deviation,
      summary.corners,
      summary.smooth);
}

TEST(ArcFit, TakesOneArcForALineAndForAnArc) {
  const Spline line = exact::cubic({{{0.0, 0.0}, {100.0, 50.0}, {600.0, 300.0}, {1000.0, 500.0}}});
  ASSERT_EQ(chain_of(line, {}, 0.002).size(), 1U);
  EXPECT_NEAR(static_cast<double>(chain_of(line, {}, 0.002)[0].bulge), 0.0, 1.0e-6);
  Spline quarter;
  quarter.append({.place = {0, 0}});
  quarter.append({.place = {0, 10'000'000}, .weight = std::sqrt(0.5F)});
  quarter.append({.place = {-10'000'000, 10'000'000}});
  const auto arc = chain_of(quarter, {}, 0.002);
  ASSERT_EQ(arc.size(), 1U);
  EXPECT_NEAR(static_cast<double>(arc[0].bulge), std::tan(std::acos(-1.0) / 8.0), 1.0e-6);
}

TEST(ArcFit, TakesCurvesThatEndWhereTheyBegin) {
  Summary summary;
  check(exact::cubic({{{0.0, 0.0}, {90.0, -10.0}, {40.0, 70.0}, {0.0, 0.0}}}), 0.002, summary);
  check(exact::cubic({{{0.0, 0.0}, {90.0, -10.0}, {90.0, -10.0}, {0.0, 0.0}}}), 0.002, summary);
  check(exact::cubic({{{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}}}), 0.002, summary);
  EXPECT_LE(summary.arcs, 60U);
}

// KERFLINE_TRIALS=10000 tests all.
TEST(ArcFit, StaysWithinToleranceOfRandomCubics) {
  const proof::Trials trials{2'000};
  Summary summary;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Spline spline = exact::random_cubic(random);
    const double tolerance = random.chance(0.7) ? 0.002 : random.magnitude(1.0e-3, 0.1);
    check(spline, tolerance, summary);
  }
  print("cubics", summary);
}

TEST(ArcFit, StaysWithinToleranceOfRandomNurbs) {
  const proof::Trials trials{300, proof::Trials::Range::kKnownFault};
  Summary summary;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Spline spline = exact::random_spline(random);
    check(spline, random.magnitude(1.0e-3, 0.05), summary);
  }
  print("splines", summary);
}

/// A biarc is compared with its curve at points that are close together, not everywhere.
TEST(ArcFit, KnownExcessOfTheToleranceNeitherGrowsNorIsGone) {
  constexpr std::uint64_t kSeed = 1011271952;
  proof::Random random{kSeed};
  const Spline spline = exact::random_spline(random);
  const double tolerance = random.magnitude(1.0e-3, 0.05);
  const ChainCheck held{spline, chain_of(spline, {}, tolerance)};
  std::printf("known excess: %.6f of the tolerance\n", held.deviation() / tolerance);
  EXPECT_GT(held.deviation(), tolerance);
  EXPECT_LE(held.deviation(), 1.0003 * tolerance);
}

}  // namespace
}  // namespace cnc

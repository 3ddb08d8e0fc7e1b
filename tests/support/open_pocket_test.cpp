#include "host-sim/pocket/open_pocket.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/pocket/areas.hpp"
#include "host-sim/pocket/fitting_radius.hpp"
#include "host-sim/pocket/strategy.hpp"
#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/adaptive_judge.hpp"
#include "tests/support/open_pocket_judge.hpp"
#include "tests/support/path_corners.hpp"
#include "tests/support/strategy_name.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::Use;
using sim::pocket::MilledPocket;
using sim::pocket::StockBox;
using sim::pocket::Strategy;
using sim::pocket::StrategyOptions;

StrategyOptions open_options(Strategy strategy, double radius_mm, const StockBox& stock) {
  StrategyOptions options;
  options.strategy = strategy;
  options.pocket.clearing = {
      .tool_radius = radius_mm, .corner_radius = 0.1 * radius_mm, .stepover = 0.8 * radius_mm};
  options.pocket.entry = {cnc::pocket::EntryKind::kHelix, 0.05, 0.9 * radius_mm};
  options.pocket.depth = options.pocket.depth_step = 0.1 * radius_mm;
  options.stock = stock;
  return options;
}

/// Returns the area that may be milled: the pockets and the surroundings of the stock.
sim::Contour area_of(const sim::Contour& pockets, const StrategyOptions& options) {
  return sim::pocket::with_surroundings(pockets, *options.stock, sim::pocket::margin_of(options));
}

/// Paths that clear `areas`, with the corners of the walls of the tool centre's area.
struct MilledAreas : MilledPocket {
  sim::Contour areas;
  std::vector<cnc::WideVec2> corners;
};

/// Returns the paths of all open areas (`is_open`), or of all closed ones.
MilledAreas mill(const sim::Contour& pockets, const StrategyOptions& options, bool is_open) {
  const sim::Contour all = area_of(pockets, options);
  MilledAreas milled;
  sim::pocket::StrategyPlanner planner{options};
  sim::ContourOffset offsetter;
  for (const sim::Contour& area : sim::pocket::areas_of(all)) {
    if (sim::pocket::is_around(area.view(), *options.stock) != is_open) continue;
    const double radius_mm =
        sim::pocket::fitting_radius(area.view(), options.pocket.clearing.tool_radius, offsetter);
    if (radius_mm == 0.0) continue;
    sim::append_loops(area.view(), milled.areas);
    const MilledPocket one = planner.mill(area.view(), radius_mm);
    milled.append(one);
    milled.narrow.insert(milled.narrow.end(), one.narrow.begin(), one.narrow.end());
    const sim::Contour locus = sim::copy_of(offsetter.offset(area.view(), -radius_mm));
    std::ranges::copy(corners_of(locus.view()), std::back_inserter(milled.corners));
  }
  return milled;
}

constexpr StockBox kStock{0.0, 0.0, 100.0, 60.0};

/// Returns the number of rows that descend in the stock.
std::size_t entries_of(const MilledPocket& path) {
  std::size_t entries = 0;
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    if (path.points[path.path().row_begin(row)].use == Use::kEntry) ++entries;
  }
  return entries;
}

class OpenPockets : public testing::TestWithParam<Strategy> {
 protected:
  static StrategyOptions options_of(double radius_mm, const StockBox& stock) {
    return open_options(GetParam(), radius_mm, stock);
  }

  /// Returns the faults of the path of a contour. @param entries greatest number of rows that may
  /// descend in the stock
  static std::string faults_of(const char* text,
                               double radius_mm,
                               std::size_t min_places,
                               std::size_t entries = 0) {
    const sim::Contour pockets = sim::contour_from_text(text, "test");
    const StrategyOptions options = options_of(radius_mm, kStock);
    const MilledAreas path = mill(pockets, options, true);
    EXPECT_TRUE(mill(pockets, options, false).points.empty());
    EXPECT_LE(entries_of(path), entries);
    EXPECT_EQ(corner_elsewhere(path, path.corners), "");
    Random random{1};
    OpenPocketJudge judge{pockets, path, options};
    const std::string faults = judge.run(random);
    EXPECT_GE(judge.places(), min_places);
    return faults;
  }
};

TEST_P(OpenPockets, AreMilledFromBesideTheStock) {
  // A slot that ends beyond the stock's edge, one that ends on it, two corners, and a slot across
  // the stock.
  EXPECT_EQ(faults_of("40 20\n60 20\n60 70\n40 70\nclosed\n", 3.0, 20), "");
  EXPECT_EQ(faults_of("40 20\n60 20\n60 60\n40 60\nclosed\n", 3.0, 20), "");
  EXPECT_EQ(faults_of("40 -5\n60 -5\n60 40\n40 40\nclosed\n", 3.0, 20), "");
  EXPECT_EQ(faults_of("70 30\n100 30\n100 60\n70 60\nclosed\n", 3.0, 20), "");
  EXPECT_EQ(faults_of("-10 20\n110 20\n110 40\n-10 40\nclosed\n", 3.0, 50), "");
}

TEST_P(OpenPockets, MayBeAllOfTheStock) {
  // The strategy `contour` begins in the middle of the stock, so that any number of entries is
  // right.
  const std::size_t entries = GetParam() == Strategy::kContour ? 1000 : 0;
  EXPECT_EQ(faults_of("-10 -10\n110 -10\n110 70\n-10 70\nclosed\n", 3.0, 250, entries), "");
}

TEST_P(OpenPockets, KeepIslandsAndWhatIsClosed) {
  const sim::Contour pockets = sim::contour_from_text(
      "30 20\n70 20\n70 70\n30 70\nclosed\n50 35 -1\n56 35 -1\nclosed\n"
      "5 5\n25 5\n25 25\n5 25\nclosed\n",
      "test");
  const StrategyOptions options = options_of(3.0, kStock);
  const MilledPocket open = mill(pockets, options, true);
  const MilledPocket closed = mill(pockets, options, false);
  EXPECT_FALSE(closed.points.empty());
  for (const auto& point : closed.points) EXPECT_LT(point.x, 25.0);
  for (const auto& point : open.points) EXPECT_GT(point.x, 25.0);
  Random random{1};
  // The path of the open pockets alone leaves the stock of the closed pocket, which the judge must
  // find.
  EXPECT_NE((OpenPocketJudge{pockets, open, options}.run(random)), "");
  MilledPocket all = open;
  all.append(closed);
  EXPECT_EQ((OpenPocketJudge{pockets, all, options}.run(random)), "");
}

TEST_P(OpenPockets, LeaveAStockAloneThatTheyDoNotReach) {
  const sim::Contour pockets = sim::contour_from_text("5 5\n25 5\n25 25\n5 25\nclosed\n", "test");
  EXPECT_TRUE(mill(pockets, options_of(3.0, kStock), true).points.empty());
}

/// Returns a stock whose border the pocket crosses on one side or on more.
StockBox random_stock(const sim::Contour& pockets, Random& random) {
  StockBox box{1.0e9, 1.0e9, -1.0e9, -1.0e9};
  for (const auto& vertex : pockets.vertices) {
    box.include({vertex.x, vertex.y, vertex.x, vertex.y});
  }
  const auto inwards = [&random](double size) {
    return random.chance(0.5) ? random.between(0.0, 0.4) * size : -0.1 * size;
  };
  const double width = box.x1 - box.x0;
  const double height = box.y1 - box.y0;
  return {box.x0 + inwards(width),
          box.y0 + inwards(height),
          box.x1 - inwards(width),
          box.y1 - inwards(height)};
}

StrategyOptions random_options(Strategy strategy,
                               double radius,
                               const StockBox& stock,
                               Random& random) {
  StrategyOptions options = open_options(strategy, radius, stock);
  auto& clearing = options.pocket.clearing;
  clearing.stepover = random.between(0.3, strategy == Strategy::kSpiral ? 0.9 : 1.8) * radius;
  options.engagement_deg = random.between(40.0, 100.0);
  if (random.chance(0.3)) options.pocket.milling = cnc::pocket::Milling::kConventional;
  return options;
}

/// Sums over the random pockets.
struct OpenTally {
  std::size_t places = 0;   ///< Sampled points in the stock.
  std::size_t entries = 0;  ///< Rows that descend in the stock of open pockets.
  std::size_t rows = 0;     ///< Rows of open pockets.
  std::size_t refused = 0;
  double engagement_deg = 0.0;  ///< Greatest excess over the permitted engagement.

  void add(const MilledPocket& open) {
    rows += open.row_ends.size();
    entries += entries_of(open);
  }
};

void judge_engagement(const MilledAreas& path, const StrategyOptions& options, OpenTally& tally) {
  sim::pocket::AdaptivePath judged;
  judged.append(path);
  judged.narrow = path.narrow;
  const AdaptiveVerdict verdict =
      judge_adaptive(path.areas.view(),
                     judged,
                     {.tool_radius_mm = options.pocket.clearing.tool_radius,
                      .engagement_deg = options.engagement_deg,
                      .depth_mm = options.pocket.depth},
                     options.stock);
  tally.engagement_deg =
      std::max(tally.engagement_deg, verdict.engagement_deg - options.engagement_deg);
  EXPECT_LE(verdict.engagement_deg, options.engagement_deg + 1.0)
      << "at " << verdict.engaged_at.transpose();
  EXPECT_LE(verdict.link_deg, 1.0);
  EXPECT_LE(verdict.left_mm, kOpenSkinMm);
}

TEST_P(OpenPockets, OfRandomShapesAreCleared) {
  OpenTally tally;
  // The judge takes longer for crescents, and return paths through tiny circles in cusps may have
  // corners.
  const bool is_adaptive = GetParam() == Strategy::kAdaptive;
  const Trials trials{is_adaptive ? 12U : 40U,
                      is_adaptive ? Trials::Range::kKnownFault : Trials::Range::kFromBase};
  for (const std::uint64_t seed : trials) {
    Random random{seed};
    cnc::pocket::PocketBench bench;
    const double radius = cnc::pocket::add_random_pocket(bench, random);
    const sim::Contour pockets = sim::copy_of(bench.pocket());
    const StockBox stock = random_stock(pockets, random);
    const StrategyOptions options = random_options(GetParam(), radius, stock, random);
    try {
      MilledAreas path = mill(pockets, options, true);
      EXPECT_EQ(corner_elsewhere(path, path.corners), "") << "KERFLINE_SEED=" << seed;
      tally.add(path);
      if (GetParam() == Strategy::kAdaptive) judge_engagement(path, options, tally);
      path.append(mill(pockets, options, false));
      OpenPocketJudge judge{pockets, path, options};
      EXPECT_EQ(judge.run(random), "") << "KERFLINE_SEED=" << seed;
      tally.places += judge.places();
    } catch (const sim::pocket::NoPocketPath&) {
      ++tally.refused;  // A part of the area is too short for a ramp.
    }
  }
  std::printf("%zu places with stock, %zu of %zu rows go down in it, %zu refused, %.2f degrees\n",
              tally.places,
              tally.entries,
              tally.rows,
              tally.refused,
              tally.engagement_deg);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    OpenPockets,
    testing::Values(Strategy::kContour, Strategy::kSpiral, Strategy::kAdaptive, Strategy::kZigzag),
    [](const auto& strategy) { return strategy_name(strategy.param); });

TEST(ClosedPockets, OfTheSameShapesAreClearedByCrescents) {
  OpenTally tally;
  for (const std::uint64_t seed : Trials{30, Trials::Range::kKnownFault}) {
    Random random{seed};
    cnc::pocket::PocketBench bench;
    const double radius = cnc::pocket::add_random_pocket(bench, random);
    const sim::Contour pockets = sim::copy_of(bench.pocket());
    const StockBox stock{-1.0e3, -1.0e3, 1.0e3, 1.0e3};
    const StrategyOptions options = random_options(Strategy::kAdaptive, radius, stock, random);
    try {
      const MilledAreas path = mill(pockets, options, false);
      EXPECT_EQ(corner_elsewhere(path, path.corners), "") << "KERFLINE_SEED=" << seed;
      judge_engagement(path, options, tally);
    } catch (const sim::pocket::NoPocketPath&) {
      ++tally.refused;  // A part of the area is too short for a ramp.
    }
  }
  std::printf("%zu refused, %.2f degrees\n", tally.refused, tally.engagement_deg);
}

/// Every point in a pocket or outside of the stock may be milled, and no other point.
TEST(OpenAreas, HaveAllThatIsBesideTheStockAroundThem) {
  for (const std::uint64_t seed : Trials{200}) {
    Random random{seed};
    cnc::pocket::PocketBench bench;
    const double radius = cnc::pocket::add_random_pocket(bench, random);
    const sim::Contour pockets = sim::copy_of(bench.pocket());
    const auto& vertex = pockets.vertices[random.below(pockets.vertices.size())];
    const StockBox stock{vertex.x + random.between(-5.0, 5.0) * radius,
                         vertex.y + random.between(-5.0, 5.0) * radius,
                         vertex.x + random.between(6.0, 40.0) * radius,
                         vertex.y + random.between(6.0, 40.0) * radius};
    const sim::Contour area = sim::pocket::with_surroundings(pockets, stock, 4.0 * radius);
    cnc::pocket::PlainContour inside;
    inside.add(area.view());
    cnc::pocket::PlainContour walls;
    walls.add(pockets.view());
    for (int i = 0; i < 100; ++i) {
      const WideVec2 place{random.between(stock.x0 - 5.0 * radius, stock.x1 + 5.0 * radius),
                           random.between(stock.y0 - 5.0 * radius, stock.y1 + 5.0 * radius)};
      const double depth = depth_in(stock, place);
      if (std::abs(depth) < kOpenSkinMm || std::abs(depth + 4.0 * radius) < kOpenSkinMm) continue;
      if (walls.distance(place) < kOpenSkinMm) continue;
      const bool is_beside = depth < 0.0 && depth > -4.0 * radius;
      const bool is_in_pocket = depth > 0.0 && walls.encloses(place);
      EXPECT_EQ(inside.encloses(place), is_beside || is_in_pocket)
          << place.x() << " " << place.y() << " KERFLINE_SEED=" << seed;
    }
  }
}

}  // namespace
}  // namespace proof

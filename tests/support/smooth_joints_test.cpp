// Tests that tool paths of pockets have corners only where the wall has them.

#include <gtest/gtest.h>

#include <string>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/strategy.hpp"
#include "tests/support/path_corners.hpp"
#include "tests/support/random_pocket.hpp"
#include "tests/support/strategy_name.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using sim::pocket::MilledPocket;
using sim::pocket::Strategy;

class SmoothJoints : public testing::TestWithParam<Strategy> {};

TEST_P(SmoothJoints, HaveCornersOnlyWhereTheWallHasThem) {
  std::uint64_t judged = 0;
  for (const std::uint64_t seed : Trials{30}) {
    Random random{seed};
    const sim::Contour area = random_pocket(random);
    const double radius = random.between(1.5, 4.0);
    sim::pocket::StrategyOptions options;
    options.strategy = GetParam();
    options.pocket.clearing = {.tool_radius = radius,
                               .corner_radius = 0.1 * radius,
                               .stepover = random.between(0.5, 1.8) * radius};
    options.pocket.entry = {cnc::pocket::EntryKind::kPlunge, 0.05, 0.9 * radius};
    options.pocket.depth = options.pocket.depth_step = 1.0;
    options.engagement_deg = random.between(40.0, 100.0);
    sim::ContourOffset offsetter;
    const sim::Contour locus = sim::copy_of(offsetter.offset(area.view(), -radius));
    if (locus.loop_ends.empty()) continue;
    const MilledPocket milled = sim::pocket::StrategyPlanner{options}.mill(area.view(), radius);
    EXPECT_EQ(corner_elsewhere(milled, corners_of(locus.view())), "") << "KERFLINE_SEED=" << seed;
    ++judged;
  }
  EXPECT_GT(judged, 0U);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    SmoothJoints,
    testing::Values(Strategy::kContour, Strategy::kSpiral, Strategy::kAdaptive, Strategy::kZigzag),
    [](const auto& strategy) { return strategy_name(strategy.param); });

}  // namespace
}  // namespace proof

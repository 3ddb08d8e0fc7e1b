// How tool paths of pockets turn from each element into the next.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/strategy.hpp"
#include "planner/pocket/loop_measures.hpp"
#include "tests/support/random_pocket.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::Use;
using sim::pocket::MilledPocket;
using sim::pocket::Strategy;

constexpr double kSmooth_deg = 0.1;
constexpr double kSamePlace_mm = 1.0e-6;

/// The angle between two directions, degrees.
double angle_between(const WideVec2& a, const WideVec2& b) {
  return std::abs(std::atan2(cnc::cross(a, b), a.dot(b))) * 180.0 / std::numbers::pi;
}

/// The vertices of a contour at which it turns.
std::vector<WideVec2> corners_of(const cnc::contour::ContourView<double>& contour) {
  std::vector<WideVec2> corners;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    const std::uint32_t first = contour.loop_begin(loop);
    const std::uint32_t last = contour.loop_ends[loop] - 1;
    for (std::uint32_t i = first; i <= last; ++i) {
      cnc::contour::Curve<double> before, after;
      const std::uint32_t previous = i > first ? i - 1 : last;
      const bool are_curves =
          cnc::pocket::make_curve(cnc::pocket::element_at(contour, loop, previous), before) &&
          cnc::pocket::make_curve(cnc::pocket::element_at(contour, loop, i), after);
      const bool turns =
          !are_curves || angle_between(before.end_tangent, after.start_tangent) > kSmooth_deg;
      if (turns) corners.push_back(contour.vertices[i].point());
    }
  }
  return corners;
}

/// Elements of a path that meet at an angle, on the floor of a level, elsewhere than at places that
/// are given.
std::string corner_elsewhere(const MilledPocket& milled, const std::vector<WideVec2>& places) {
  const auto path = milled.path();
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    cnc::contour::Curve<double> before;
    bool has_before = false;
    for (std::uint32_t i = path.row_begin(row); i + 1 < path.row_ends[row]; ++i) {
      const auto& from = path.points[i];
      const auto& to = path.points[i + 1];
      cnc::contour::Curve<double> curve;
      const bool is_flat = from.z == to.z && from.use != Use::kEntry;
      const bool moves = cnc::pocket::make_curve({from.point(), to.point(), from.bulge}, curve);
      if (is_flat && !moves) continue;
      if (is_flat && has_before) {
        const double angle = angle_between(before.end_tangent, curve.start_tangent);
        const bool is_there = std::ranges::any_of(places, [&](const WideVec2& place) {
          return (place - from.point()).norm() <= kSamePlace_mm;
        });
        if (angle > kSmooth_deg && !is_there) {
          return std::to_string(angle) + " degrees at " + std::to_string(from.x) + " " +
                 std::to_string(from.y) + ", uses " +
                 std::to_string(static_cast<int>(path.points[i - 1].use)) + " " +
                 std::to_string(static_cast<int>(from.use));
        }
      }
      before = curve;
      has_before = is_flat;
    }
  }
  return {};
}

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
    [](const auto& strategy) -> std::string {
      switch (strategy.param) {
        case Strategy::kContour:
          return "Contour";
        case Strategy::kSpiral:
          return "Spiral";
        case Strategy::kAdaptive:
          return "Adaptive";
        default:
          return "Zigzag";
      }
    });

}  // namespace
}  // namespace proof

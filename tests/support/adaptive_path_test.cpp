#include "host-sim/pocket/adaptive_path.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "host-sim/contour/contour_text.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "tests/support/adaptive_judge.hpp"
#include "tests/support/random_pocket.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using sim::pocket::AdaptiveOptions;
using sim::pocket::AdaptivePath;

constexpr double kMaxAbove_deg = 1.0;
constexpr double kRounding_mm = 1.0e-6;
constexpr double kMaxLeft_mm = 2.0e-3;

AdaptiveVerdict expect_cleared(const sim::Contour& area, const AdaptiveOptions& options) {
  const AdaptivePath path = sim::pocket::adaptive_path(area.view(), options);
  const AdaptiveVerdict verdict = judge_adaptive(area.view(), path, options);
  EXPECT_LE(verdict.engagement_deg, options.engagement_deg + kMaxAbove_deg)
      << "at " << verdict.engaged_at.transpose();
  EXPECT_LE(verdict.link_deg, kMaxAbove_deg);
  EXPECT_LE(verdict.gouge_mm, kRounding_mm);
  EXPECT_LE(verdict.left_mm, kMaxLeft_mm);
  return verdict;
}

sim::Contour contour_of(std::string_view text) { return sim::contour_from_text(text, "test"); }

TEST(AdaptivePaths, ClearASquare) {
  const AdaptiveVerdict verdict =
      expect_cleared(contour_of("0 0\n40 0\n40 40\n0 40\nclosed\n"), {.tool_radius_mm = 3.0});
  EXPECT_EQ(verdict.excepted, 0U);
  EXPECT_GT(verdict.judged, 1000U);
  // A path that never comes near the permitted engagement would be too long.
  EXPECT_GT(verdict.engagement_deg, 50.0);
}

TEST(AdaptivePaths, ClearACircleBySpiral) {
  const AdaptiveVerdict verdict =
      expect_cleared(contour_of("30 0 1\n-30 0 1\nclosed\n"), {.tool_radius_mm = 4.0});
  EXPECT_EQ(verdict.excepted, 0U);
  EXPECT_GT(verdict.engagement_deg, 50.0);
}

TEST(AdaptivePaths, ClearARing) {
  expect_cleared(contour_of("30 0 1\n-30 0 1\nclosed\n12 0 -1\n-12 0 -1\nclosed\n"),
                 {.tool_radius_mm = 4.0, .engagement_deg = 45.0});
}

TEST(AdaptivePaths, ClearAroundIslands) {
  expect_cleared(contour_of("0 0\n80 0\n80 50\n0 50\nclosed\n20 20\n20 30\n30 30\n30 20\nclosed\n"
                            "60 25 -1\n50 25 -1\nclosed\n"),
                 {.tool_radius_mm = 3.0, .engagement_deg = 70.0});
}

TEST(AdaptivePaths, ClearAnAngle) {
  expect_cleared(contour_of("0 0\n50 0\n50 15\n15 15\n15 50\n0 50\nclosed\n"),
                 {.tool_radius_mm = 4.0, .engagement_deg = 90.0});
}

TEST(AdaptivePaths, ListNarrowStretches) {
  // Two rooms with a door of 1.1 tool diameters between them.
  const sim::Contour rooms = contour_of(
      "0 0\n30 0\n30 12\n40 12\n40 0\n70 0\n70 30\n40 30\n40 18.6\n30 18.6\n30 30\n0 30\nclosed\n");
  const AdaptiveOptions options{.tool_radius_mm = 3.0};
  const AdaptivePath path = sim::pocket::adaptive_path(rooms.view(), options);
  ASSERT_EQ(path.narrow.size(), 1U);
  EXPECT_NEAR(path.narrow[0].width_mm, 6.6, 1.0e-3);
  EXPECT_GT(path.narrow[0].length_mm, 9.0);
  EXPECT_GT(expect_cleared(rooms, options).excepted, 0U);
}

/// Two rooms with a door of twice `half_mm` between them. For a door narrower than the tool (6 mm),
/// the area of the tool's centre has a cusp on either side of the door.
sim::Contour rooms_with_door(double half_mm) {
  const auto corner = [](double x, double y) { return fmt::format("{:g} {:.9f}\n", x, y); };
  return contour_of("0 -15\n30 -15\n" + corner(30.0, -half_mm) + corner(40.0, -half_mm) +
                    "40 -15\n70 -15\n70 15\n40 15\n" + corner(40.0, half_mm) +
                    corner(30.0, half_mm) + "30 15\n0 15\nclosed\n");
}

TEST(AdaptivePaths, ListTheTipsOfSharpCusps) {
  const AdaptiveOptions options{.tool_radius_mm = 3.0, .engagement_deg = 100.0};
  EXPECT_EQ(expect_cleared(rooms_with_door(3.0 - 1.0e-2), options).excepted, 0U);
  const sim::Contour rooms = rooms_with_door(3.0 - 1.0e-5);
  EXPECT_GT(expect_cleared(rooms, options).excepted, 0U);
  const AdaptivePath path = sim::pocket::adaptive_path(rooms.view(), options);
  ASSERT_EQ(path.narrow.size(), 2U);
  for (const auto& tip : path.narrow) {
    EXPECT_NEAR(tip.width_mm, 6.0, 1.0e-4);
    // The walls of the cusp make an angle of 4 degrees where the narrow stretch begins.
    EXPECT_NEAR(tip.length_mm, 0.18, 0.05);
  }
}

TEST(AdaptivePaths, ClearRoomsWithoutADoor) {
  // The tool does not fit through the door, so both rooms have an entry.
  const sim::Contour rooms = contour_of(
      "0 0\n30 0\n30 13\n40 13\n40 0\n70 0\n70 30\n40 30\n40 17\n30 17\n30 30\n0 30\nclosed\n");
  expect_cleared(rooms, {.tool_radius_mm = 3.0});
}

TEST(AdaptivePaths, RefuseAToolThatFitsNowhere) {
  const sim::Contour slot = contour_of("0 0\n30 0\n30 5\n0 5\nclosed\n");
  EXPECT_THROW((void)sim::pocket::adaptive_path(slot.view(), {.tool_radius_mm = 3.0}),
               std::invalid_argument);
}

TEST(AdaptivePaths, RefuseOptionsOutOfRange) {
  const sim::Contour square = contour_of("0 0\n40 0\n40 40\n0 40\nclosed\n");
  for (const AdaptiveOptions& options : {AdaptiveOptions{.tool_radius_mm = 0.0},
                                         AdaptiveOptions{.engagement_deg = 5.0},
                                         AdaptiveOptions{.engagement_deg = 180.0},
                                         AdaptiveOptions{.depth_mm = 0.0},
                                         AdaptiveOptions{.slope = 0.0},
                                         AdaptiveOptions{.return_limit_mm = -1.0}}) {
    EXPECT_THROW((void)sim::pocket::adaptive_path(square.view(), options), std::invalid_argument);
  }
}

TEST(AdaptivePaths, ClearRandomPockets) {
  const Trials trials{40};
  std::uint64_t refused = 0;
  for (const std::uint64_t seed : trials) {
    Random random{seed};
    const sim::Contour area = random_pocket(random);
    AdaptiveOptions options{.tool_radius_mm = random.between(2.0, 4.0),
                            .engagement_deg = random.between(40.0, 100.0)};
    options.entry = static_cast<cnc::pocket::EntryKind>(random.below(3));
    sim::ContourOffset offset;
    if (offset.offset(area.view(), -options.tool_radius_mm).loop_ends.size() == 0) continue;
    try {
      expect_cleared(area, options);
    } catch (const sim::pocket::NoPocketPath&) {
      ++refused;  // The tool fits into a part of the area only straight down.
    }
  }
  if (trials.judges_shares()) {
    EXPECT_LE(10 * refused, trials.count());
  }
}

/// Lengths of the descending parts of a path's entries, mm: in lines and in arcs.
struct WaysDown {
  double lines_mm = 0.0;
  double arcs_mm = 0.0;
  double steepest = 0.0;  ///< Greatest slope of the lines: descent over length.
};

WaysDown ways_down(const AdaptivePath& path) {
  WaysDown ways;
  const auto view = path.path();
  for (std::size_t row = 0; row < view.row_ends.size(); ++row) {
    for (std::uint32_t i = view.row_begin(row); i + 1 < view.row_ends[row]; ++i) {
      const auto& from = view.points[i];
      const auto& to = view.points[i + 1];
      if (from.use != cnc::pocket::Use::kEntry || to.z >= from.z) continue;
      const double chord = std::hypot(to.x - from.x, to.y - from.y);
      (from.bulge == 0.0 ? ways.lines_mm : ways.arcs_mm) += chord;
      if (from.bulge == 0.0) ways.steepest = std::max(ways.steepest, (from.z - to.z) / chord);
    }
  }
  return ways;
}

TEST(AdaptivePaths, EnterSlotsByARampAlongThem) {
  const double slope = AdaptiveOptions{}.slope;
  for (const std::string_view slot : {"0 0\n30 0\n30 6\n0 6\nclosed\n",
                                      "0 0\n30 0 1\n30 6\n0 6 1\nclosed\n",
                                      "0 0\n30 0\n30 6.4\n0 6.4\nclosed\n"}) {
    const AdaptiveOptions options{.tool_radius_mm = 3.0 - 5.0e-4, .depth_mm = 4.0};
    const sim::Contour area = contour_of(slot);
    EXPECT_GT(expect_cleared(area, options).excepted, 0U);
    const WaysDown ways = ways_down(sim::pocket::adaptive_path(area.view(), options));
    EXPECT_EQ(ways.arcs_mm, 0.0);
    EXPECT_GE(ways.lines_mm, options.depth_mm / slope * (1.0 - 1.0e-9));
    EXPECT_LE(ways.steepest, slope * (1.0 + 1.0e-9));
  }
}

TEST(AdaptivePaths, EnterWideRoomsAsTheyAreTold) {
  const sim::Contour room = contour_of("0 0\n40 0\n40 30\n0 30\nclosed\n");
  AdaptiveOptions options{.tool_radius_mm = 3.0, .entry = cnc::pocket::EntryKind::kRamp};
  expect_cleared(room, options);
  EXPECT_EQ(ways_down(sim::pocket::adaptive_path(room.view(), options)).arcs_mm, 0.0);
  options.entry = cnc::pocket::EntryKind::kPlunge;
  expect_cleared(room, options);
  const WaysDown straight = ways_down(sim::pocket::adaptive_path(room.view(), options));
  EXPECT_EQ(straight.lines_mm + straight.arcs_mm, 0.0);
  EXPECT_EQ(straight.steepest, INFINITY);
}

TEST(AdaptivePaths, PlungeIntoAHoleAsWideAsTheToolWhereAskedTo) {
  const sim::Contour hole = contour_of("3 0 1\n-3 0 1\nclosed\n");
  AdaptiveOptions options{.tool_radius_mm = 3.0 - 5.0e-4};
  EXPECT_THROW((void)sim::pocket::adaptive_path(hole.view(), options), sim::pocket::NoPocketPath);
  options.entry = cnc::pocket::EntryKind::kPlunge;
  expect_cleared(hole, options);
}

}  // namespace
}  // namespace proof

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "host-sim/wall/carve/beam_carver.hpp"
#include "host-sim/wall/carve/drawn_walls.hpp"
#include "host-sim/wall/carve/wall_lean.hpp"
#include "host-sim/wall/solid_check.hpp"
#include "tests/host-sim/wall/degrees.hpp"
#include "tests/host-sim/wall/walled_part.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::wall {
namespace {

constexpr double kCellMm = 0.007;
constexpr double kHalfAngleDeg = 7.0;

Loop polygon(std::size_t corners, double radius) {
  Loop loop;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle =
        (static_cast<double>(i) + 0.3) * 360.0 * kDegree / static_cast<double>(corners);
    loop.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return loop;
}

Loop rectangle(double width, double length, double turn_rad) {
  Loop loop;
  for (const auto& [x, y] :
       {std::array{-1, -1}, std::array{1, -1}, std::array{1, 1}, std::array{-1, 1}}) {
    const double across = 0.5 * width * x;
    const double along = 0.5 * length * y;
    loop.emplace_back(across * std::cos(turn_rad) - along * std::sin(turn_rad),
                      across * std::sin(turn_rad) + along * std::cos(turn_rad));
  }
  return loop;
}

/// Returns an L. Its inner corner is convex in a pit, and concave at a post.
Loop angle_iron() {
  return {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.1}, {0.1, 0.1}, {0.1, 0.5}, {-0.5, 0.5}};
}

/// The carved part: its walls, and the lean of each.
struct CarvedPart {
  std::vector<DrawnWall> walls;
  std::vector<WallLean> leans;  ///< Lean of each wall.
  std::size_t strokes = 0;
};

CarvedPart carve(const WalledPart& part, const WallMilling& milling, double heat_rad = 0.0) {
  const std::vector<BeamStroke> strokes = strokes_of(part, milling);
  Columns columns{
      {-part.size_mm, -part.size_mm, part.size_mm, part.size_mm, 0.0, -part.depth_mm - 0.1},
      kCellMm};
  BeamCarver carver{columns, {.half_angle_rad = kHalfAngleDeg * kDegree, .heat_rad = heat_rad}};
  double lowest = 0.0;
  for (const BeamStroke& stroke : strokes) {
    carver.carve(stroke);
    for (const BeamPose& pose : stroke) lowest = std::min(lowest, pose.tip.z());
  }
  CarvedPart carved;
  carved.strokes = strokes.size();
  const auto walls = drawn_walls(part.mesh(),
                                 {.low_mm = lowest,
                                  .high_mm = 0.0,
                                  .cell_mm = kCellMm,
                                  .burn_deg = kHalfAngleDeg + heat_rad / kDegree + 5.0});
  for (const DrawnWall& wall : walls) {
    // The outer sides of the block are not milled.
    if (!part.is_post && wall.place.at.dot(wall.place.outward) > 0.0) continue;
    const std::optional<WallLean> lean = lean_at(columns, wall.place);
    EXPECT_TRUE(lean.has_value()) << wall.place.at.transpose() << ", " << wall.place.high_mm;
    if (!lean) continue;
    carved.walls.push_back(wall);
    carved.leans.push_back(*lean);
  }
  return carved;
}

/// A part, and whether a beam reaches all of its walls.
struct NamedPart {
  std::string name;
  Loop floor;
  bool is_post = false;
  double depth_mm = 0.6;
};

std::vector<NamedPart> named_parts() {
  return {{"square pit", rectangle(0.8, 0.8, 0.0), false},
          {"turned pit", rectangle(0.7, 0.9, 0.4), false},
          {"post", rectangle(0.5, 0.4, 0.2), true},
          {"thin wall", rectangle(0.08, 0.9, 0.3), true},
          {"pit with a convex corner", angle_iron(), false},
          {"post with an inside corner", angle_iron(), true},
          {"round pit", polygon(24, 0.4), false},
          {"round post", polygon(24, 0.4), true},
          {"slot narrower than the cone at the rim", rectangle(0.14, 0.8, 0.0), false}};
}

/// Returns whether a draft leaves material at the rim of the part.
bool has_rim(const NamedPart& part, double draft_deg) {
  return !part.is_post || part.name != "thin wall" || draft_deg < 3.0;
}

void expect_walls_as_drawn(double draft_deg) {
  for (const NamedPart& named : named_parts()) {
    if (!has_rim(named, draft_deg)) continue;
    SCOPED_TRACE(testing::Message() << named.name << ", draft " << draft_deg);
    const WalledPart part =
        walled_part(named.floor, named.is_post, named.depth_mm, draft_deg * kDegree);
    ASSERT_NO_THROW(require_solid(part.mesh(), named.name));
    const CarvedPart carved =
        carve(part, {.half_angle_rad = kHalfAngleDeg * kDegree, .avoids = true});
    EXPECT_EQ(carved.walls.size(), named.floor.size());
    for (std::size_t i = 0; i < carved.walls.size(); ++i) {
      EXPECT_NEAR(carved.walls[i].angle_deg, draft_deg, 1.0e-3);
      EXPECT_NEAR(carved.leans[i].angle_deg, draft_deg, 0.5) << carved.leans[i].points;
    }
  }
}

TEST(CarvedWalls, AreUprightAsDrawn) { expect_walls_as_drawn(0.0); }
TEST(CarvedWalls, HaveASmallDraftAsDrawn) { expect_walls_as_drawn(2.0); }
TEST(CarvedWalls, HaveALargeDraftAsDrawn) { expect_walls_as_drawn(12.0); }

TEST(CarvedWalls, LeanByTheHalfAngleUnderAnUprightBeam) {
  for (const double draft_deg : {0.0, 2.0, 12.0}) {
    for (const NamedPart& named : named_parts()) {
      // A thin wall that is burned from both sides disappears.
      if (named.name == "thin wall") continue;
      SCOPED_TRACE(testing::Message() << named.name << ", draft " << draft_deg);
      const WalledPart part =
          walled_part(named.floor, named.is_post, named.depth_mm, draft_deg * kDegree);
      const CarvedPart carved = carve(part, {.half_angle_rad = kHalfAngleDeg * kDegree});
      for (const WallLean& lean : carved.leans) {
        EXPECT_NEAR(lean.angle_deg, std::max(draft_deg, kHalfAngleDeg), 0.2) << lean.points;
      }
    }
  }
}

}  // namespace
}  // namespace sim::wall

#include "host-sim/surface/path/waterline_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "host-sim/surface/path/level_distance.hpp"
#include "host-sim/surface/path/tip_grid.hpp"
#include "tests/host-sim/surface/path_judge.hpp"
#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/support/random_cutter.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

RowOptions random_levels(proof::Random& random, const cnc::surface::Profile& tool) {
  RowOptions options;
  options.tool = tool;
  options.tolerance_mm = random.magnitude(tool.rise > 0.0 ? 0.02 : 0.002, 0.1);
  options.digit_mm = options.tolerance_mm < 0.005 ? 1.0e-5 : 1.0e-4;
  if (random.chance(0.3)) options.floor_mm = random.between(-1.0, 2.0);
  if (random.chance(0.5)) options.margin_mm = random.between(0.0, 3.0);
  if (random.chance(0.3) && tool.rise == 0.0) options.allowance_mm = random.between(0.0, 0.5);
  if (random.chance(0.3)) options.direction = cnc::pocket::Milling::kConventional;
  options.lines_only = random.chance(0.2);
  return options;
}

/// Removes about a tenth of the facets.
void make_holes(proof::Random& random, Mesh& mesh) {
  const auto facets = mesh.facets;
  mesh.facets.clear();
  for (const auto& facet : facets) {
    if (!random.chance(0.1)) mesh.facets.push_back(facet);
  }
  if (mesh.facets.empty()) mesh.facets = facets;
}

TEST(WaterlinePath, NeverCutsInAndHasNoMoreAirThanTwiceTheTolerance) {
  const proof::Trials trials{80};
  double worst = -1.0;
  std::size_t paths = 0;
  std::size_t runs = 0;
  std::size_t stretches = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    Mesh mesh = random.chance(0.5) ? random_hills(random) : random_waves(random, 12, 1.0);
    if (random.chance(0.3)) make_holes(random, mesh);
    RowOptions options = random_levels(random, proof::random_cutter(random));
    options.step_mm = random.between(0.1, 0.4) * (top_of(mesh) + 1.0);
    const Judge judge{mesh, options};
    SurfacePath path;
    try {
      path = waterline_path(mesh, options);
    } catch (const std::invalid_argument&) {
      continue;  // No level contains a line.
    }
    ++paths;
    runs += path.runs.size();
    stretches += path.stretches.size();
    std::size_t looked = 0;
    double deepest = -1.0;
    for_places(text_of(path, options), 0.05, [&](const Vector3d& tip) {
      deepest = std::max(deepest, judge.gouge(tip));
      ++looked;
    });
    EXPECT_GT(looked, 0U);
    EXPECT_LE(deepest, 1.0e-6);
    worst = std::max(worst, deepest);
    std::size_t high = 0;
    std::size_t judged = 0;
    for_level_places(path, 0.05, [&](const Vector3d& tip) {
      if (++judged % 7 == 0 && judge.is_too_high(tip)) ++high;
    });
    EXPECT_EQ(high, 0U) << "of " << judged / 7;
  }
  std::printf(
      "cuts in by %.3g mm; %zu paths, %zu runs, %zu stretches\n", worst, paths, runs, stretches);
}

/// Returns the upper part of a ring of a round tube about the Z axis; of a ball, if the tube's
/// middle is on the axis.
Mesh upper_ring(double middle_mm, double tube_mm) {
  constexpr int kSectors = 720;
  constexpr int kRings = 360;
  Mesh mesh;
  for (int ring = 0; ring <= kRings; ++ring) {
    const double share = middle_mm > 0.0 ? 1.0 : 0.5;  // Fraction of half a turn.
    const double angle = std::numbers::pi * share * ring / kRings;
    const double out = middle_mm + tube_mm * std::cos(angle);
    for (int i = 0; i < kSectors; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kSectors;
      mesh.points.emplace_back(
          out * std::cos(turn), out * std::sin(turn), tube_mm * std::sin(angle));
    }
  }
  const auto point = [](int ring, int sector) {
    return static_cast<std::uint32_t>(ring * kSectors + sector % kSectors);
  };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int i = 0; i < kSectors; ++i) {
      mesh.facets.push_back({point(ring, i), point(ring, i + 1), point(ring + 1, i)});
      mesh.facets.push_back({point(ring, i + 1), point(ring + 1, i + 1), point(ring + 1, i)});
    }
  }
  return mesh;
}

TEST(WaterlinePath, GoesRoundABallAndATorusAtTheirDistance) {
  RowOptions options;
  options.tool = {.radius_mm = 1.5, .flat_mm = 0.0, .corner_mm = 1.5};
  options.step_mm = 0.7;
  options.margin_mm = 3.0;
  options.floor_mm = 0.0;
  constexpr double kTube = 5.0;
  constexpr double kFacets = 1.0e-4;  // The chords of the facets are inside of the round form.
  for (const double middle : {0.0, 12.0}) {
    const SurfacePath path = waterline_path(upper_ring(middle, kTube), options);
    std::size_t places = 0;
    for_level_places(path, 0.05, [&](const Vector3d& tip) {
      const double out = std::abs(tip.head<2>().norm() - middle);
      const double distance = std::hypot(out, tip.z() + options.tool.radius_mm);
      EXPECT_GE(distance, kTube + options.tool.radius_mm - kFacets);
      EXPECT_LE(distance, kTube + options.tool.radius_mm + 2.0 * options.tolerance_mm);
      ++places;
    });
    EXPECT_GT(places, 1'000U);
    // 5 mm in levels of 0.625 mm, the last of which is at the equator.
    const auto rows = std::ranges::count(path.stretches, StretchUse::kRow, &SurfaceStretch::use);
    EXPECT_EQ(rows, middle > 0.0 ? 16 : 8);
  }
}

void add_box(double low, double high, double top, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const double z : {-1.0, top}) {
    for (const double y : {low, high}) {
      for (const double x : {low, high}) mesh.points.emplace_back(x, y, z);
    }
  }
  constexpr std::array<std::array<std::uint32_t, 3>, 12> kFacets{{{0, 2, 1},
                                                                  {1, 2, 3},
                                                                  {4, 5, 6},
                                                                  {5, 7, 6},
                                                                  {0, 1, 4},
                                                                  {1, 5, 4},
                                                                  {2, 6, 3},
                                                                  {3, 6, 7},
                                                                  {0, 4, 2},
                                                                  {2, 4, 6},
                                                                  {1, 3, 5},
                                                                  {3, 7, 5}}};
  for (const auto& [a, b, c] : kFacets) mesh.facets.push_back({first + a, first + b, first + c});
}

/// One level lies in the top of the lower box, and one in the floor.
TEST(WaterlinePath, GoesRoundUprightWallsAndKeepsLevelsInFlatBottoms) {
  Mesh mesh;
  add_box(0.0, 20.0, 2.0, mesh);
  add_box(5.0, 15.0, 4.0, mesh);
  RowOptions options;
  options.step_mm = 1.0;
  options.margin_mm = 6.0;
  options.floor_mm = 0.0;
  for (const double corner : {0.0, 0.5, 2.0}) {
    options.tool = {.radius_mm = 2.0, .flat_mm = 2.0 - corner, .corner_mm = corner};
    const SurfacePath path = waterline_path(mesh, options);
    EXPECT_EQ(path.runs.size(), 2U) << corner;
    std::vector<double> levels;
    for (const SurfaceStretch& stretch : path.stretches) {
      if (stretch.use != StretchUse::kRow) continue;
      levels.push_back(stretch.start().z());
    }
    ASSERT_EQ(levels.size(), 4U) << corner;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(levels[i], 3.0 - static_cast<double>(i), 2.0 * options.tolerance_mm);
    }
    for_level_places(path, 0.02, [&](const Vector3d& tip) {
      const double half = tip.z() > 1.5 ? 5.0 : 10.0;
      const Vector2d beyond = ((tip.head<2>().array() - 10.0).abs() - half).max(0.0);
      // The corner of the tool touches the edge at the top of the box, or the tool's side touches
      // its wall.
      const double over = tip.z() + corner - (tip.z() > 1.5 ? 4.0 : 2.0);
      const bool is_corner = over > 0.0;
      const double radius = is_corner ? corner : options.tool.radius_mm;
      const double distance =
          is_corner ? std::hypot(beyond.norm() - options.tool.flat_mm, over) : beyond.norm();
      EXPECT_GE(distance, radius - 1.0e-6) << tip.transpose() << " corner " << corner;
      EXPECT_LE(distance, radius + 2.0 * options.tolerance_mm) << tip.transpose();
    });
  }
}

/// Returns whether five by five nodes of a grid are all above a level, or all below it.
bool is_block(const TipGrid& tips, std::size_t middle, double level_mm, bool is_high) {
  const std::size_t columns = tips.grid().columns();
  for (std::size_t row = 0; row < 5; ++row) {
    for (std::size_t column = 0; column < 5; ++column) {
      const std::size_t node = middle + row * columns + column - 2 * columns - 2;
      if ((tips.height(node) > level_mm) != is_high) return false;
    }
  }
  return true;
}

/// Compares with a denser grid: if the tip changes from well above a level to well below it, or
/// back, a line must be near.
TEST(WaterlinePath, LosesNoLine) {
  std::size_t crossings = 0;
  for (const std::uint64_t seed : proof::Trials{20}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Mesh mesh = random_waves(random, 14, 0.8);
    RowOptions options;
    options.tool = {.radius_mm = 1.0, .flat_mm = 0.0, .corner_mm = 1.0};
    options.tolerance_mm = 0.005;
    options.step_mm = random.between(0.2, 0.5);
    const SurfacePath path = waterline_path(mesh, options);
    std::map<double, std::vector<Vector2d>> lines;
    for_level_places(
        path, 0.02, [&lines](const Vector3d& tip) { lines[tip.z()].emplace_back(tip.head<2>()); });
    const SurfaceTracer tracer{mesh, options};
    const PlanGrid grid{mesh, 0.0, 0.08};
    const TipGrid tips{tracer, grid, {}};
    for (const auto& [height, places] : lines) {
      const double level = height - tracer.lift_mm();
      for (std::size_t row = 2; row + 2 < grid.rows(); ++row) {
        for (std::size_t column = 6; column + 7 < grid.columns(); ++column) {
          const std::size_t node = grid.node(column, row);
          const bool is_high = tips.height(node) > level;
          if (is_high == (tips.height(node + 1) > level)) continue;
          if (!is_block(tips, node - 4, level, is_high)) continue;
          if (!is_block(tips, node + 5, level, !is_high)) continue;
          ++crossings;
          const Vector2d middle = 0.5 * (grid.at(node) + grid.at(node + 1));
          double least = std::numeric_limits<double>::infinity();
          for (const Vector2d& place : places) least = std::min(least, (place - middle).norm());
          EXPECT_LE(least, 0.1) << middle.transpose() << " at " << height;
        }
      }
    }
  }
  EXPECT_GT(crossings, 0U);
  std::printf("%zu crossings\n", crossings);
}

TEST(WaterlinePath, KeepsTheStockOnTheSideOfItsDirection) {
  Mesh mesh;
  add_box(0.0, 20.0, 2.0, mesh);
  RowOptions options;
  options.tool = {.radius_mm = 2.0, .flat_mm = 2.0};
  options.margin_mm = 6.0;
  options.floor_mm = 0.0;
  for (const auto milling : {cnc::pocket::Milling::kClimb, cnc::pocket::Milling::kConventional}) {
    options.direction = milling;
    double area = 0.0;
    const SurfacePath path = waterline_path(mesh, options);
    Vector2d before{10.0, 10.0};
    for_level_places(path, 0.1, [&](const Vector3d& tip) {
      const Vector2d seen = tip.head<2>() - Vector2d{10.0, 10.0};
      area += cnc::cross(before, seen);
      before = seen;
    });
    // Climb milling runs clockwise around a boss.
    EXPECT_EQ(area < 0.0, milling == cnc::pocket::Milling::kClimb);
  }
}

/// On a slope of 45 degrees, the passes of a ball are farther apart than their levels, and a flat
/// tool leaves steps.
TEST(WaterlinePath, HasLevelsAsNearAsAScallopAsksOnSteepSlopes) {
  constexpr double kScallop = 0.02;
  const cnc::surface::Profile ball{.radius_mm = 2.0, .flat_mm = 0.0, .corner_mm = 2.0};
  const double along = 2.0 * std::sqrt(4.0 - (2.0 - kScallop) * (2.0 - kScallop));
  EXPECT_NEAR(level_distance(ball, kScallop), along / std::numbers::sqrt2, 1.0e-3);
  const cnc::surface::Profile flat{.radius_mm = 2.0, .flat_mm = 2.0};
  EXPECT_NEAR(level_distance(flat, kScallop), kScallop * std::numbers::sqrt2, 1.0e-3);
}

TEST(WaterlinePath, RefusesASurfaceWithoutAnyLine) {
  Mesh mesh;
  add_box(0.0, 20.0, 2.0, mesh);
  RowOptions options;
  options.tool = {.radius_mm = 2.0, .flat_mm = 2.0};
  EXPECT_THROW((void)waterline_path(mesh, options), std::invalid_argument);
}

}  // namespace
}  // namespace sim::surface

#include "host-sim/surface/path/pencil_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "host-sim/surface/path/surface_program.hpp"
#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

RowOptions ball_options(double radius) {
  RowOptions options;
  options.tool = {.radius_mm = radius, .flat_mm = 0.0, .corner_mm = radius};
  options.tolerance_mm = 0.01;
  return options;
}

/// Returns a grid of points at the heights of a function, with two facets for each square.
template <typename Height>
Mesh mesh_of(double size, std::uint32_t count, const Height& height) {
  Mesh mesh;
  for (std::uint32_t row = 0; row < count; ++row) {
    for (std::uint32_t column = 0; column < count; ++column) {
      const double x = size * column / (count - 1) - 0.5 * size;
      const double y = size * row / (count - 1) - 0.5 * size;
      mesh.points.emplace_back(x, y, height(x, y));
    }
  }
  add_facets(count, count, mesh);
  return mesh;
}

/// Returns positions of the tip along all stretches.
std::vector<Vector3d> tips_of(const SurfacePath& path) {
  std::vector<Vector3d> tips;
  for (const SurfaceStretch& stretch : path.stretches) {
    for (const ContourVertex& vertex : stretch.vertices) {
      tips.push_back(stretch.place_of(vertex));
    }
  }
  return tips;
}

void expect_no_gouge(const Mesh& mesh, const RowOptions& options, const SurfacePath& path) {
  const DropCutter exact{mesh, options.tool};
  for (const Vector3d& tip : tips_of(path)) {
    EXPECT_GE(tip.z(), exact.tip_height(tip.head<2>()) - 1.0e-6);
  }
}

double plan_length_of(const SurfacePath& path) {
  double length = 0.0;
  for (const SurfaceStretch& stretch : path.stretches) {
    length += stretch.vertices.back().x - stretch.vertices.front().x;
  }
  return length;
}

TEST(PencilPath, FollowsTheBottomOfAGrooveInAnyDirection) {
  for (const std::uint64_t seed : proof::Trials{60}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const double angle = random.chance(0.3)
                             ? 0.5 * std::numbers::pi * static_cast<double>(random.below(4))
                             : random.between(-4.0, 4.0);
    const Vector2d along{std::cos(angle), std::sin(angle)};
    const Vector2d across{-along.y(), along.x()};
    const double rise = random.between(0.4, 2.0);
    Mesh mesh;
    for (const double way : {-10.0, 10.0}) {
      for (const double beside : {-8.0, 0.0, 8.0}) {
        const Vector2d place = way * along + beside * across;
        mesh.points.emplace_back(place.x(), place.y(), rise * std::abs(beside));
      }
    }
    add_facets(2, 3, mesh);
    const RowOptions options = ball_options(random.between(0.5, 2.0));
    const PencilPath pencil = pencil_path(mesh, options, {});
    expect_no_gouge(mesh, options, pencil.path);
    EXPECT_EQ(pencil.path.runs.size(), 1U);
    // The ball extends beyond the ends of the groove.
    EXPECT_GE(plan_length_of(pencil.path), 20.0 - 1.0e-3);
    for (const Vector3d& tip : tips_of(pencil.path)) {
      EXPECT_LE(std::abs(across.dot(tip.head<2>())), options.tolerance_mm);
    }
  }
}

TEST(PencilPath, FollowsNothingOnAHillAndInABowlOfFineFacets) {
  const auto hill = [](double x, double y) { return std::sqrt(400.0 - x * x - y * y); };
  const Mesh up = mesh_of(16.0, 81, hill);
  const Mesh down = mesh_of(16.0, 81, [&hill](double x, double y) { return -hill(x, y); });
  for (const double radius : {0.5, 1.5, 6.0}) {
    EXPECT_THROW(static_cast<void>(pencil_path(up, ball_options(radius), {})),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(pencil_path(down, ball_options(radius), {})),
                 std::invalid_argument);
  }
}

/// Returns a box of 10 mm on a plane of 30 mm, with vertical walls.
Mesh box_on_plane(double height) {
  Mesh mesh;
  for (const auto& [half, z] :
       {std::array{15.0, 0.0}, std::array{5.0, 0.0}, std::array{5.0, height}}) {
    mesh.points.emplace_back(-half, -half, z);
    mesh.points.emplace_back(half, -half, z);
    mesh.points.emplace_back(half, half, z);
    mesh.points.emplace_back(-half, half, z);
  }
  for (std::uint32_t ring = 0; ring < 2; ++ring) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t outer = 4 * ring + i;
      const std::uint32_t next = 4 * ring + (i + 1) % 4;
      mesh.facets.push_back({outer, next, next + 4});
      mesh.facets.push_back({outer, next + 4, outer + 4});
    }
  }
  mesh.facets.push_back({8, 9, 10});
  mesh.facets.push_back({8, 10, 11});
  return mesh;
}

TEST(PencilPath, GoesAllRoundTheFootOfABox) {
  for (const double height : {0.7, 4.0}) {
    const Mesh mesh = box_on_plane(height);
    const RowOptions options = ball_options(1.5);
    const PencilPath pencil = pencil_path(mesh, options, {});
    expect_no_gouge(mesh, options, pencil.path);
    EXPECT_EQ(pencil.path.runs.size(), 1U);
    // Beside a low box, the ball touches its upper edge.
    const double beside =
        height > 1.5 ? 1.5 : std::sqrt(1.5 * 1.5 - (1.5 - height) * (1.5 - height));
    const double around = 40.0 + 2.0 * std::numbers::pi * beside;
    EXPECT_NEAR(plan_length_of(pencil.path), around, 0.3);
    for (const Vector3d& tip : tips_of(pencil.path)) EXPECT_LE(tip.z(), 0.06) << tip.transpose();
  }
}

TEST(PencilPath, FollowsAllBranchesOfCrossingGrooves) {
  // A groove along X and one along Y of the same depth form four arms from the middle.
  const auto height = [](double x, double y) { return std::min(std::abs(x), std::abs(y)); };
  const Mesh mesh = mesh_of(20.0, 81, height);
  const RowOptions options = ball_options(1.0);
  const PencilPath pencil = pencil_path(mesh, options, {});
  expect_no_gouge(mesh, options, pencil.path);
  std::array<double, 4> farthest{};
  for (const Vector3d& tip : tips_of(pencil.path)) {
    farthest[0] = std::max(farthest[0], tip.x());
    farthest[1] = std::max(farthest[1], -tip.x());
    farthest[2] = std::max(farthest[2], tip.y());
    farthest[3] = std::max(farthest[3], -tip.y());
  }
  for (const double reached : farthest) EXPECT_GT(reached, 9.5);
  EXPECT_GE(plan_length_of(pencil.path), 4.0 * 9.0);
  EXPECT_LE(plan_length_of(pencil.path), 4.0 * 11.0);
}

TEST(PencilPath, NeverCutsInOnHills) {
  std::size_t found = 0;
  for (const std::uint64_t seed : proof::Trials{60}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Mesh mesh = random_hills(random);
    RowOptions options = ball_options(random.magnitude(0.3, 2.0));
    if (random.chance(0.3)) options.floor_mm = 0.5;
    // A fine grid over a large mesh would take long.
    if (options.tool.radius_mm < 0.03 * mesh.points.back().x()) continue;
    try {
      const PencilPath pencil = pencil_path(mesh, options, {.angle_rad = 0.35, .min_mm = 0.5});
      expect_no_gouge(mesh, options, pencil.path);
      ++found;
    } catch (const std::invalid_argument&) {
      // The surface has no valley.
    }
  }
  EXPECT_GT(found, 0U);
}

}  // namespace
}  // namespace sim::surface

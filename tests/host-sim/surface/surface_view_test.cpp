#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host-sim/cut/stroke.hpp"
#include "host-sim/stock/surface_comparison.hpp"
#include "host-sim/surface/patch/surface_fit.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/view/carved_stock.hpp"
#include "host-sim/surface/view/stretch_line.hpp"
#include "host-sim/surface/view/surface_scenes.hpp"
#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using testing::HasSubstr;

constexpr stock::Cutter kBall{.kind = stock::CutterKind::kBall, .diameter_mm = 3.0};

RowOptions row_options() {
  RowOptions options;
  options.tool = profile_of(kBall);
  options.step_mm = 0.4;
  return options;
}

PointGrid grid_of(std::size_t count, double pitch_mm) {
  PointGrid grid{.rows = count, .columns = count, .points = {}};
  for (std::size_t row = 0; row < count; ++row) {
    for (std::size_t column = 0; column < count; ++column) {
      const double x = pitch_mm * static_cast<double>(column);
      const double y = pitch_mm * static_cast<double>(row);
      grid.points.emplace_back(x, y, std::sin(x) * std::cos(0.7 * y));
    }
  }
  return grid;
}

TEST(SurfaceView, PointsOfAStretchAreOnItAndTheirChordsNear) {
  for (const std::uint64_t seed : proof::Trials{50}) {
    proof::Random random{seed};
    SurfaceStretch stretch{
        .plane = Slice{.from = {1.0, 2.0}, .direction = {0.6, 0.8}, .length = 9.0},
        .vertices = {{0.0, 1.0, random.signed_magnitude(0.01, 0.8)},
                     {random.between(3.0, 8.0), 2.0, 0.0},
                     {9.0, 2.5, 0.0}}};
    const double chord_mm = random.magnitude(1.0e-4, 0.05);
    const SpaceLine line = line_of(stretch, chord_mm);
    EXPECT_EQ(line.front(), Eigen::Vector3d(1.0, 2.0, 1.0));
    EXPECT_NEAR((line.back() - Eigen::Vector3d(6.4, 9.2, 2.5)).norm(), 0.0, 1.0e-9);
    const cut::Stroke arc{
        .from = {0.0, 1.0}, .to = {stretch.vertices[1].x, 2.0}, .bulge = stretch.vertices[0].bulge};
    for (double share = 0.0; share <= 1.0; share += 0.01) {
      const drawing::Place place = cut::place_at(arc, share);
      const Eigen::Vector3d on_arc = stretch.place_of({place.x(), place.y(), 0.0});
      double nearest = 1.0e9;
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Eigen::Vector3d way = line[i + 1] - line[i];
        const double along = std::clamp((on_arc - line[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (line[i] + along * way - on_arc).norm());
      }
      EXPECT_LE(nearest, 1.01 * chord_mm + 1.0e-9);
    }
  }
}

TEST(SurfaceView, TheCarvedBlockHasNoGougeAndALowerPathHas) {
  for (const std::uint64_t seed : proof::Trials{3}) {
    proof::Random random{seed};
    const Mesh mesh = random_waves(random, 21, 0.4);
    SurfacePath path = row_path(mesh, row_options());
    const auto figures_after = [&](SurfacePath& driven) {
      stock::Stock block = block_for(mesh, driven, {.cell_mm = 0.05});
      carve(block, driven, kBall);
      return stock::compared(block, kBall, mesh).figures;
    };
    const stock::SurfaceFigures sound = figures_after(path);
    EXPECT_EQ(sound.gouge.min_mm3, 0.0);
    // No gouge is certain, although bounds are apart on slopes.
    EXPECT_TRUE(sound.worst_gouges.empty());
    EXPECT_GT(sound.gouge.max_mm3, 0.0);
    EXPECT_GT(sound.cells, 20'000U);
    ASSERT_FALSE(sound.worst_rests.empty());
    for (const stock::WorstPlace& rest : sound.worst_rests) {
      EXPECT_GT(rest.off_mm, 0.0);
      EXPECT_LE(rest.unreachable_mm, rest.off_mm);
    }
    for (SurfaceStretch& stretch : path.stretches) {
      for (ContourVertex& vertex : stretch.vertices) vertex.y -= 0.1;
    }
    EXPECT_GT(figures_after(path).deepest_gouge.min_mm, 0.03);
  }
}

TEST(SurfaceView, ScenesHaveWhatTheyShow) {
  const PointGrid grid = grid_of(12, 0.5);
  const Mesh mesh = triangulated(grid);
  const SpaceScene data = data_scene(mesh, grid);
  EXPECT_EQ(data.subtitle, "12 × 12 points");
  EXPECT_EQ(data.lines.at(0).lines.size(), 24U);
  EXPECT_EQ(data.colours.size(), mesh.points.size());
  const SpaceScene offset = offset_scene(mesh, grid, profile_of(kBall));
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    EXPECT_GE(offset.mesh.points[i].z(), mesh.points[i].z() - 1.0e-9);
  }
  const SurfacePath path = row_path(mesh, row_options());
  const SpaceScene paths = path_scene(mesh, path, 7.0);
  ASSERT_EQ(paths.lines.size(), 3U);
  EXPECT_EQ(paths.lines[0].lines.size() + paths.lines[1].lines.size(), path.stretches.size());
  EXPECT_EQ(paths.lines[2].lines.size(), path.runs.size() + 1);
  EXPECT_EQ(paths.lines[2].lines.front().front().z(), 7.0);
}

TEST(SurfaceView, PatchesAreDrawnWithAllTheirBorders) {
  const PointGrid grid = grid_of(20, 0.4);
  const patch::PatchSurface fitted = patch::fitted_surface(grid, 0.02);
  const SpaceScene scene = patch_scene(fitted);
  EXPECT_EQ(scene.lines.at(0).lines.size(), 4 * fitted.patches.size());
  EXPECT_EQ(scene.colours.size(), scene.mesh.points.size());
  // Points of patches of different size have different colours.
  EXPECT_GE(scene.key.samples.size(), 1U);
  EXPECT_THAT(draw_space("patches.svg", scene, {}), HasSubstr("border"));
}

TEST(SurfaceView, AGapInTheSurfaceIsAGapInThePlacesOfTheTip) {
  // Two squares with 10 mm between them.
  Mesh mesh{.points = {{0, 0, 0},
                       {4, 0, 0},
                       {4, 4, 0},
                       {0, 4, 0},
                       {14, 0, 0},
                       {18, 0, 0},
                       {18, 4, 0},
                       {14, 4, 0}},
            .facets = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
  const SpaceScene scene = offset_scene(mesh, {}, profile_of(kBall));
  for (const auto& facet : scene.mesh.facets) {
    for (const std::uint32_t point : facet) {
      const double x = scene.mesh.points[point].x();
      EXPECT_TRUE(x < 5.6 || x > 12.4) << x;
    }
  }
}

}  // namespace
}  // namespace sim::surface

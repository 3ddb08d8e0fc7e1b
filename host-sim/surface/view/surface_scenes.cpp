#include "host-sim/surface/view/surface_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host-sim/stock/height_map.hpp"
#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/view/stretch_line.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr const char* kWireColour = "#30363d";
constexpr double kWirePx = 0.7;

/// Returns the rows and columns of a grid as lines. For a large grid, returns only every n-th line
/// and adds a note to `key`.
SpaceLines wire_of(const PointGrid& grid, const char* label, PictureKey& key) {
  constexpr std::size_t kMaxLines = 130;
  SpaceLines wire{.sample = {.colour = kWireColour, .width_px = kWirePx, .label = label},
                  .lines = {}};
  const std::size_t stride = (std::max(grid.rows, grid.columns) + kMaxLines - 1) / kMaxLines;
  const auto is_drawn = [stride](std::size_t i, std::size_t count) {
    return i % stride == 0 || i + 1 == count;
  };
  const auto add = [&](std::size_t count, auto point_of) {
    SpaceLine line;
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3d& point = point_of(i);
      if (std::isfinite(point.z())) {
        line.push_back(point);
        continue;
      }
      wire.lines.push_back(std::move(line));
      line.clear();
    }
    wire.lines.push_back(std::move(line));
  };
  for (std::size_t row = 0; row < grid.rows; ++row) {
    if (!is_drawn(row, grid.rows)) continue;
    add(grid.columns, [&](std::size_t i) -> const Vector3d& { return grid.at(row, i); });
  }
  for (std::size_t column = 0; column < grid.columns; ++column) {
    if (!is_drawn(column, grid.columns)) continue;
    add(grid.rows, [&](std::size_t i) -> const Vector3d& { return grid.at(i, column); });
  }
  if (stride > 1) key.notes.push_back(fmt::format("only one of every {} lines is drawn", stride));
  return wire;
}

/// Returns a regular grid over the bounding box of a mesh, without heights.
PointGrid lattice_over(const Mesh& mesh) {
  constexpr double kAlongLongSide = 160.0;
  SpaceBox box;
  for (const Vector3d& point : mesh.points) box.include(point);
  const Vector3d size = box.most - box.least;
  const double pitch = std::max(size.x(), size.y()) / kAlongLongSide;
  const auto count = [pitch](double length) {
    return std::max(2.0, std::round(length / pitch) + 1.0);
  };
  const double rows = count(size.y());
  const double columns = count(size.x());
  PointGrid grid{.rows = static_cast<std::size_t>(rows),
                 .columns = static_cast<std::size_t>(columns),
                 .points = {}};
  for (double row = 0.0; row < rows; row += 1.0) {
    for (double column = 0.0; column < columns; column += 1.0) {
      grid.points.emplace_back(box.least.x() + size.x() * column / (columns - 1.0),
                               box.least.y() + size.y() * row / (rows - 1.0),
                               0.0);
    }
  }
  return grid;
}

/// Returns the mesh of a grid. Facets at points without a height are left out.
Mesh mesh_of(const PointGrid& grid) {
  Mesh mesh = triangulated(grid);
  std::erase_if(mesh.facets, [&](const auto& facet) {
    return std::ranges::any_of(
        facet, [&](std::uint32_t point) { return !std::isfinite(mesh.points[point].z()); });
  });
  // Moves unused points onto the mesh, because bounding boxes and scales include all points.
  for (Vector3d& point : mesh.points) {
    if (!std::isfinite(point.z())) point = mesh.points[mesh.facets.front().front()];
  }
  return mesh;
}

bool has_level_facet(const PointGrid& grid) {
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      const double sum = grid.at(row, column).z() + grid.at(row, column + 1).z() +
                         grid.at(row + 1, column).z() + grid.at(row + 1, column + 1).z();
      if (std::isfinite(sum)) return true;
    }
  }
  return false;
}

/// Returns the length of the longer side of a patch, in quadrilaterals of the grid.
double side_of(const patch::GridPatch& patch) {
  return std::max(patch.u.to - patch.u.from, patch.v.to - patch.v.from);
}

/// Adds a patch as facets. Patches share no points, so that each has a separate colour.
void add_patch(const patch::GridPatch& patch, const Colour& colour, SpaceScene& scene) {
  const auto steps = static_cast<std::uint32_t>(std::clamp(4.0 * side_of(patch), 6.0, 32.0));
  const auto first = static_cast<std::uint32_t>(scene.mesh.points.size());
  for (std::uint32_t u = 0; u <= steps; ++u) {
    for (std::uint32_t v = 0; v <= steps; ++v) {
      scene.mesh.points.push_back(
          patch.shape.at(static_cast<double>(u) / steps, static_cast<double>(v) / steps));
      scene.colours.push_back(colour);
      if (u == steps || v == steps) continue;
      const std::uint32_t corner = first + u * (steps + 1) + v;
      const std::uint32_t above = corner + steps + 1;
      scene.mesh.facets.push_back({corner, corner + 1, above + 1});
      scene.mesh.facets.push_back({corner, above + 1, above});
    }
  }
}

SpaceLine line_of(const patch::BezierCurve& curve) {
  constexpr int kChords = 24;
  SpaceLine line;
  for (int i = 0; i <= kChords; ++i) line.push_back(curve.at(static_cast<double>(i) / kChords));
  return line;
}

Colour patch_colour(double share) {
  constexpr std::array<Colour, 3> kPatchTable{
      {{0xf2, 0xa6, 0x5a}, {0xf8, 0xf0, 0xcc}, {0xa6, 0xc9, 0xe8}}};
  const Colour& low = share < 0.5 ? kPatchTable[0] : kPatchTable[1];
  const Colour& high = share < 0.5 ? kPatchTable[1] : kPatchTable[2];
  const double rest = share < 0.5 ? 2.0 * share : 2.0 * share - 1.0;
  const auto between = [rest](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + rest * (b - a)));
  };
  return {between(low.red, high.red), between(low.green, high.green), between(low.blue, high.blue)};
}

/// Adds the sides of a block, from the rim of its upper surface down to the bottom. The upper
/// surface has `columns` × `rows` points.
void add_sides(Mesh& mesh, std::uint32_t columns, std::uint32_t rows, double bottom_mm) {
  std::vector<std::uint32_t> rim;
  for (std::uint32_t i = 0; i + 1 < columns; ++i) rim.push_back(i);
  for (std::uint32_t i = 0; i + 1 < rows; ++i) rim.push_back(i * columns + columns - 1);
  for (std::uint32_t i = columns - 1; i > 0; --i) rim.push_back((rows - 1) * columns + i);
  for (std::uint32_t i = rows - 1; i > 0; --i) rim.push_back(i * columns);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const std::uint32_t point : rim) {
    const Vector3d above = mesh.points[point];
    mesh.points.push_back(above);
    mesh.points.emplace_back(above.x(), above.y(), bottom_mm);
  }
  const auto size = static_cast<std::uint32_t>(rim.size());
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t upper = first + 2 * i;
    const std::uint32_t next = first + 2 * ((i + 1) % size);
    mesh.facets.push_back({upper, upper + 1, next + 1});
    mesh.facets.push_back({upper, next + 1, next});
  }
}

}  // namespace

SpaceScene data_scene(const Mesh& mesh, const std::optional<PointGrid>& grid) {
  SpaceScene scene{.title = "Measured surface", .mesh = mesh};
  scene.colours = height_colours(scene.mesh, scene.key);
  if (grid) {
    scene.subtitle = fmt::format("{} × {} points", grid->rows, grid->columns);
    scene.lines.push_back(wire_of(*grid, "rows and columns", scene.key));
  } else {
    scene.title = "Surface";
    scene.subtitle = fmt::format("{} facets", mesh.facets.size());
  }
  return scene;
}

SpaceScene offset_scene(const Mesh& mesh,
                        const std::optional<PointGrid>& grid,
                        const cnc::surface::Profile& tool) {
  const DropCutter cutter{mesh, tool};
  DropCutter::Hint hint;
  PointGrid tips = grid ? *grid : lattice_over(mesh);
  for (Vector3d& tip : tips.points) tip.z() = cutter.tip_height(tip.head<2>(), hint);
  if (!has_level_facet(tips)) throw std::invalid_argument{"the surface is nowhere under the tool"};
  SpaceScene scene{.title = "Positions of the tool's tip",
                   .subtitle = fmt::format("{} × {} places", tips.rows, tips.columns),
                   .mesh = mesh_of(tips)};
  scene.colours = height_colours(scene.mesh, scene.key);
  scene.lines.push_back(wire_of(tips, "rows and columns", scene.key));
  return scene;
}

SpaceScene patch_scene(const patch::PatchSurface& patches) {
  SpaceScene scene{
      .title = "Bézier patches over the positions of the tip",
      .subtitle = fmt::format(
          "{} patches fit {} × {} points", patches.patches.size(), patches.rows, patches.columns)};
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const patch::GridPatch& patch : patches.patches) {
    least = std::min(least, side_of(patch));
    most = std::max(most, side_of(patch));
  }
  const double doublings = std::max(std::log2(most / least), 1.0);
  SpaceLines borders{.sample = {.colour = "#1b2733", .width_px = 1.6, .label = "border"},
                     .lines = {}};
  for (const patch::GridPatch& patch : patches.patches) {
    add_patch(patch, patch_colour(std::log2(side_of(patch) / least) / doublings), scene);
    for (const double end : {0.0, 1.0}) {
      borders.lines.push_back(line_of(patch.shape.curve_at_u(end)));
      borders.lines.push_back(line_of(patch.shape.curve_at_v(end)));
    }
  }
  scene.lines.push_back(std::move(borders));
  const auto entry = [](double share, double side) {
    return KeySample{
        .shape = SampleShape::kArea,
        .colour = hex(patch_colour(share)),
        .label = fmt::format("side of {:g} grid {}", side, side == 1.0 ? "cell" : "cells")};
  };
  scene.key.samples.push_back(entry(0.0, least));
  if (most > least) scene.key.samples.push_back(entry(1.0, most));
  return scene;
}

SpaceScene path_scene(const Mesh& mesh, const SurfacePath& path, double safe_mm) {
  SpaceScene scene{.title = "Path of the tool's tip", .mesh = mesh};
  SpaceBox box;
  for (const Vector3d& point : mesh.points) box.include(point);
  const double chord_mm = 2.0e-4 * (box.most - box.least).norm();
  SpaceLines rows{.sample = {.colour = "#1558b0", .width_px = 1.2, .label = "rows"}, .lines = {}};
  SpaceLines links{.sample = {.colour = "#0b8f3c", .width_px = 1.8, .label = "links"}, .lines = {}};
  SpaceLines rapids{.sample = {.colour = "#d1342b",
                               .width_px = 1.5,
                               .dashes_px = "7 5",
                               .label = "lifts and rapids"},
                    .lines = {}};
  SpaceLine rapid;
  std::size_t begin = 0;
  for (const SurfaceRun& run : path.runs) {
    for (std::size_t i = begin; i < run.end; ++i) {
      const SurfaceStretch& stretch = path.stretches[i];
      (stretch.use == StretchUse::kLink ? links : rows).lines.push_back(line_of(stretch, chord_mm));
    }
    const Vector3d first = line_of(path.stretches[begin], chord_mm).front();
    const Vector3d last = line_of(path.stretches[run.end - 1], chord_mm).back();
    rapid.emplace_back(first.x(), first.y(), safe_mm);
    rapid.push_back(first);
    rapids.lines.push_back(std::move(rapid));
    rapid = {last, {last.x(), last.y(), safe_mm}};
    begin = run.end;
  }
  rapids.lines.push_back(std::move(rapid));
  scene.subtitle = fmt::format("{} stretches in {} {}",
                               path.stretches.size(),
                               path.runs.size(),
                               path.runs.size() == 1 ? "run" : "runs");
  scene.lines = {std::move(rows), std::move(links), std::move(rapids)};
  return scene;
}

SpaceScene carved_scene(const stock::Stock& block) {
  constexpr std::size_t kMaxBlocks = 400'000;
  const stock::HeightMap map{block, kMaxBlocks};
  SpaceScene scene{.title = "Carved stock"};
  const auto columns = static_cast<std::size_t>(map.columns());
  const auto rows = static_cast<std::size_t>(map.rows());
  PointGrid top{.rows = rows, .columns = columns, .points = {}};
  for (int row = 0; row < map.rows(); ++row) {
    for (int column = 0; column < map.columns(); ++column) {
      top.points.emplace_back(map.x_of(column), map.y_of(row), map.height(column, row));
    }
  }
  scene.mesh = triangulated(top);
  scene.colours = height_colours(scene.mesh, scene.key);
  add_sides(scene.mesh,
            static_cast<std::uint32_t>(columns),
            static_cast<std::uint32_t>(rows),
            map.box().bottom);
  constexpr Colour kSide{0xb9, 0xbe, 0xc6};
  scene.colours.resize(scene.mesh.points.size(), kSide);
  const stock::VolumeBounds removed = block.removed();
  scene.subtitle = fmt::format("{:.1f} to {:.1f} mm³ removed", removed.min_mm3, removed.max_mm3);
  return scene;
}

}  // namespace sim::surface

#include "host-sim/cli/surface_pictures.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/plot/deviation_picture.hpp"
#include "host-sim/plot/picture_file.hpp"
#include "host-sim/report/stock_text.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/stock/surface_comparison.hpp"
#include "host-sim/surface/view/carved_stock.hpp"
#include "host-sim/surface/view/surface_scenes.hpp"

namespace sim {
namespace {

/// Option of a picture, with the member for its file, and whether the picture requires a path.
struct PictureOption {
  const char* name;
  std::string SurfacePictures::*file;
  bool needs_path;
  const char* help;
};

constexpr std::array<PictureOption, 6> kPictures{{
    {"--picture-data", &SurfacePictures::data, false, "Draw the surface as read, SVG or PNG"},
    {"--picture-offset", &SurfacePictures::offset, false, "Draw the positions of the tool's tip"},
    {"--picture-patches", &SurfacePictures::patches, false, "Fit patches and draw them"},
    {"--picture-paths", &SurfacePictures::paths, true, "Draw the path over the surface"},
    {"--picture-carved", &SurfacePictures::carved, true, "Draw the stock that the path carves"},
    {"--picture-map",
     &SurfacePictures::map,
     true,
     "Draw the error of that stock against the surface in plan: gouges red, rests blue, with "
     "a\nlist of the worst points"},
}};

Viewpoint viewpoint_of(const SurfacePictures& pictures) {
  if (pictures.view_deg.empty()) return {};
  return {.azimuth_deg = pictures.view_deg[0], .elevation_deg = pictures.view_deg[1]};
}

void draw(const SurfacePictures& pictures, const std::string& file, SpaceScene scene) {
  write_picture(file, draw_space(file, std::move(scene), viewpoint_of(pictures)));
}

}  // namespace

void add_surface_picture_options(CLI::App& command, SurfacePictures& pictures) {
  for (const PictureOption& picture : kPictures) {
    mark_file(
        command.add_option(picture.name, pictures.*picture.file, picture.help)->type_name("FILE"),
        FileRole::kOutput);
  }
  command
      .add_option("--picture-cell",
                  pictures.cell_mm,
                  "Resolution of the carved stock, mm; default: 600,000 cells in total")
      ->check(in_range(stock::kMinCellMm, stock::kGreatestCellMm, "mm"))
      ->type_name("MM");
  command
      .add_option("--picture-view",
                  pictures.view_deg,
                  "Direction from which pictures are seen, degrees: azimuth from X "
                  "counter-clockwise, and elevation\nabove the plan, 5 to 85; default: -60,35")
      ->expected(2)
      ->delimiter(',')
      ->type_name("AZIMUTH,ELEVATION");
}

void check_surface_pictures(const SurfacePictures& pictures, const char* instead) {
  constexpr double kLowestView = 5.0;
  constexpr double kHighestView = 85.0;
  for (const PictureOption& picture : kPictures) {
    const std::string& file = pictures.*picture.file;
    require_picture_name(picture.name, file);
    if (file.empty() || !picture.needs_path || instead == nullptr) continue;
    throw std::invalid_argument(
        fmt::format("{}: there is no path to draw with {}", picture.name, instead));
  }
  if (pictures.view_deg.empty()) return;
  const double azimuth = pictures.view_deg[0];
  const double elevation = pictures.view_deg[1];
  if (std::abs(azimuth) <= 360.0 && elevation >= kLowestView && elevation <= kHighestView) return;
  throw std::invalid_argument(
      fmt::format("--picture-view {:g},{:g}: takes an azimuth of -360 to 360 and an elevation of "
                  "{:g} to {:g} degrees",
                  azimuth,
                  elevation,
                  kLowestView,
                  kHighestView));
}

void draw_surface(const SurfacePictures& pictures,
                  const surface::SurfaceInput& input,
                  const stock::Cutter& cutter) {
  std::optional<surface::PointGrid> grid = input.grid;
  // The points of the mesh have already been rotated and moved.
  if (grid) grid->points = input.mesh.points;
  if (!pictures.data.empty()) draw(pictures, pictures.data, data_scene(input.mesh, grid));
  if (pictures.offset.empty()) return;
  SpaceScene scene = offset_scene(input.mesh, grid, profile_of(cutter));
  scene.subtitle += "  ·  " + to_string(cutter);
  draw(pictures, pictures.offset, std::move(scene));
}

void draw_patches(const SurfacePictures& pictures, const surface::patch::PatchSurface& patches) {
  if (pictures.patches.empty()) return;
  draw(pictures, pictures.patches, surface::patch_scene(patches));
}

void draw_path(const SurfacePictures& pictures,
               const surface::Mesh& mesh,
               const PicturedPath& pictured,
               const stock::Cutter& cutter) {
  if (!pictures.paths.empty()) {
    SpaceScene scene = surface::path_scene(mesh, pictured.path, pictured.safe_mm);
    scene.subtitle += "  ·  " + to_string(cutter);
    draw(pictures, pictures.paths, std::move(scene));
  }
  if (pictures.carved.empty() && pictures.map.empty()) return;
  stock::Stock block = surface::block_for(
      mesh, pictured.path, {.top_mm = pictured.stock_top_mm, .cell_mm = pictures.cell_mm});
  surface::carve(block, pictured.path, cutter);
  if (!pictures.carved.empty()) {
    SpaceScene scene = surface::carved_scene(block);
    scene.subtitle += "  ·  " + to_string(cutter);
    draw(pictures, pictures.carved, std::move(scene));
  }
  if (pictures.map.empty()) return;
  const stock::SurfaceComparison comparison = stock::compared(block, cutter, mesh);
  write_picture(
      pictures.map,
      draw_deviation(
          pictures.map, comparison, "Carved stock against the surface", to_string(cutter)));
  for (const auto& [name, fact] : surface_facts(comparison.figures)) {
    terminal::print(stderr, "{}: {}\n", name, fact);
  }
}

}  // namespace sim

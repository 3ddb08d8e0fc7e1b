#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/path/surface_path.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Pictures that `kerfline surface` draws: names of files, empty for none.
struct SurfacePictures {
  std::string data;
  std::string offset;
  std::string patches;
  std::string paths;
  std::string carved;
  std::string map;
  /// Size of the cells of the carved stock; empty for a size that suits the stock.
  std::optional<double> cell_mm{};
  std::vector<double> view_deg{};  ///< Azimuth and elevation, degrees; empty for the defaults.

  [[nodiscard]] bool need_path() const { return !paths.empty() || !carved.empty() || !map.empty(); }
};

/// Path of a job and the data that its pictures require.
struct PicturedPath {
  surface::SurfacePath path;
  double safe_mm = 0.0;
  std::optional<double> stock_top_mm;
};

/// Adds the options that begin with `--picture-`.
void add_surface_picture_options(CLI::App& command, SurfacePictures& pictures);

/// Checks the options. Throws std::invalid_argument for a name that no picture can have, and for
/// pictures of a path if the job has no path.
/// @param instead the option that replaces the path; null if there is a path
void check_surface_pictures(const SurfacePictures& pictures, const char* instead);

/// Draws the surface as it was read, and the positions of the tip.
void draw_surface(const SurfacePictures& pictures,
                  const surface::SurfaceInput& input,
                  const stock::Cutter& cutter);
/// Draws patches.
void draw_patches(const SurfacePictures& pictures, const surface::patch::PatchSurface& patches);
/// Draws a path and the stock that it carves. Compares the stock with the surface, and prints the
/// error.
void draw_path(const SurfacePictures& pictures,
               const surface::Mesh& mesh,
               const PicturedPath& pictured,
               const stock::Cutter& cutter);

}  // namespace sim

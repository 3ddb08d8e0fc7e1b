#pragma once

#include <memory>
#include <string>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/smooth_tips.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim {

/// Options of `kerfline surface` for fitting patches to the positions of a tool's tip.
struct PatchOptions {
  std::string file;     ///< File for the patches; empty for none.
  bool smooth = false;  ///< Whether the path follows the patches.
  /// Whether to count flat pieces as paper 4 does, instead of writing a program.
  bool like_paper = false;
  /// Tolerance of the fit, mm; 0 stands for 1 mm if `like_paper`, otherwise for the path's
  /// tolerance.
  double fit_mm = 0.0;
  double flatness_mm = 0.5;  ///< Greatest thickness of a flat piece.
};

/// Fits smooth patches to a grid, for the path that options of rows require. Throws
/// std::invalid_argument for patches that fold.
/// @pre the fit's tolerance is above 0; the grid has at least two rows and columns
[[nodiscard]] std::shared_ptr<const surface::SmoothTips> smooth_tips(
    const surface::PointGrid& grid, const surface::RowOptions& rows, const PatchOptions& options);

/// Prints the error of the patches of a path, writes them if the options require it, and returns
/// them.
const surface::patch::PatchSurface& reported_patches(const surface::SmoothTips& smooth,
                                                     const PatchOptions& options);

/// Fits a smooth composite Bezier surface to the positions of a tool's tip over each point of a
/// grid. Prints its error, writes it and counts its flat pieces if the options require that, and
/// returns it.
/// @pre the fit's tolerance is above 0; the grid has at least two rows and columns
surface::patch::PatchSurface fit_patches(const surface::PointGrid& grid,
                                         const stock::Cutter& cutter,
                                         const PatchOptions& options);

}  // namespace sim

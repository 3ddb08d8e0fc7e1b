#pragma once

#include <memory>
#include <string>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/smooth_tips.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim {

/// How `kerfline surface` fits patches to the places of a tool's tip.
struct PatchOptions {
  std::string file;          ///< Where they are written; empty: they are not.
  bool smooth = false;       ///< The path follows them.
  bool like_paper = false;   ///< Count flat pieces as paper 4 does, in place of a program.
  double fit_mm = 0.0;       ///< Tolerance of the fit; 0: 1 mm for the paper, else the path's.
  double flatness_mm = 0.5;  ///< Greatest thickness of a flat piece.
};

/// Fits smooth patches to a grid, for the path that options of rows ask for.
/// Throws std::invalid_argument for patches that fold.
/// @pre the fit's tolerance is above 0; the grid has two rows and columns at least
[[nodiscard]] std::shared_ptr<const surface::SmoothTips> smooth_tips(
    const surface::PointGrid& grid, const surface::RowOptions& rows, const PatchOptions& options);

/// Prints how well patches of a path fit, writes them where the options ask for it, and returns
/// them.
const surface::patch::PatchSurface& reported_patches(const surface::SmoothTips& smooth,
                                                     const PatchOptions& options);

/// Fits a smooth composite Bezier surface to the places of a tool's tip over each point of a grid,
/// tells how well it fits, writes and counts what the options ask for, and returns it.
/// @pre the fit's tolerance is above 0; the grid has two rows and columns at least
surface::patch::PatchSurface fit_patches(const surface::PointGrid& grid,
                                         const stock::Cutter& cutter,
                                         const PatchOptions& options);

}  // namespace sim

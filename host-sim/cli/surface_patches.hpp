#pragma once

#include <string>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim {

/// How `kerfline surface` fits patches to the places of a tool's tip.
struct PatchOptions {
  std::string file;          ///< Where they are written; empty: they are not.
  bool like_paper = false;   ///< Count flat pieces as paper 4 does, in place of a program.
  double fit_mm = 0.0;       ///< Tolerance of the fit; 0: 1 mm for the paper, else the path's.
  double flatness_mm = 0.5;  ///< Greatest thickness of a flat piece.
};

/// Fits a smooth composite Bezier surface to the places of a tool's tip over each point of a grid,
/// tells how well it fits, writes and counts what the options ask for, and returns it.
/// @pre the fit's tolerance is above 0; the grid has two rows and columns at least
surface::patch::PatchSurface fit_patches(const surface::PointGrid& grid,
                                         const stock::Cutter& cutter,
                                         const PatchOptions& options);

}  // namespace sim

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/surface/path/surface_path.hpp"
#include "planner/gcode/print_grid.hpp"

namespace sim::surface {

/// Numbers of blocks and lengths of a program.
struct SurfaceProgramFigures {
  std::size_t arcs = 0;   ///< Number of motion lines with G2 or G3.
  std::size_t lines = 0;  ///< Number of motion lines with G1.
  double row_mm = 0.0;
  double link_mm = 0.0;
  std::size_t lifts = 0;
  double lowest_mm = 0.0;
  double highest_mm = 0.0;
};

/// Computes the figures of a path.
[[nodiscard]] SurfaceProgramFigures figures_of(const SurfacePath& path);

/// Writes a path over a surface as G-code. After the start of spindle and coolant, each run has a
/// rapid at the safe height, a rapid to just above the stock, a descent at the plunge feed, and its
/// stretches. Level stretches use arcs of G17, those along X use G18, those along Y use G19. The
/// tip never descends faster than in a plunge. Throws std::invalid_argument if a point is too far
/// from zero for a program.
/// @param heading comment lines at the top
/// @param ramp_slope slope of a ramp above the first stretch of each run, mm per mm; without a
/// value the tool plunges straight down
/// @pre the safe height is above the path
[[nodiscard]] std::string program_of(const SurfacePath& path,
                                     const pocket::MillSettings& mill,
                                     cnc::gcode::PrintGrid grid,
                                     const std::vector<std::string>& heading,
                                     std::optional<double> ramp_slope = {});

}  // namespace sim::surface

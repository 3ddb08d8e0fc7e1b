#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/surface/path/surface_path.hpp"
#include "planner/gcode/print_grid.hpp"

namespace sim::surface {

/// Numbers of blocks, lengths and heights of a program.
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

/// Writes a path over a surface as G-code. The program first starts spindle and coolant. Each run
/// then has a rapid at the safe height, a rapid down to slightly above the stock, a descent at the
/// plunge feed, and its stretches. Arcs in level stretches use G17, in stretches along X G18, and
/// in stretches along Y G19. The tip never descends faster than the plunge feed. Throws
/// std::invalid_argument if a point is too far from zero for a program.
/// @param heading comment lines at the top
/// @param ramp_slope slope of a ramp above the start of each run, mm per mm. Without a value, the
/// tool plunges straight down
/// @pre the safe height is above the path
[[nodiscard]] std::string program_of(const SurfacePath& path,
                                     const pocket::MillSettings& mill,
                                     cnc::gcode::PrintGrid grid,
                                     const std::vector<std::string>& heading,
                                     std::optional<double> ramp_slope = {});

}  // namespace sim::surface

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/surface/path/surface_path.hpp"
#include "planner/gcode/print_grid.hpp"

namespace sim::surface {

/// Blocks and lengths of a program.
struct SurfaceProgramFigures {
  std::size_t arcs = 0;   ///< Motion lines with G2 or G3.
  std::size_t lines = 0;  ///< Motion lines with G1.
  double row_mm = 0.0;
  double link_mm = 0.0;
  std::size_t lifts = 0;
  double lowest_mm = 0.0;
  double highest_mm = 0.0;
};

/// Measures a path.
[[nodiscard]] SurfaceProgramFigures figures_of(const SurfacePath& path);

/// Writes a path over a surface as G-code: spindle and coolant, then for each run a rapid at the
/// safe height, a rapid to just above the stock, a descent at the plunge feed and its stretches,
/// level ones with arcs of G17, those along X of G18, those along Y of G19. The tip descends no
/// faster than a plunge. Throws std::invalid_argument where a point is too far from zero for a
/// program.
/// @param heading lines of comment at the top
/// @param ramp_slope of a ramp above the first stretch of each run, mm per mm; none: straight down
/// @pre the safe height is above the path
[[nodiscard]] std::string program_of(const SurfacePath& path,
                                     const pocket::MillSettings& mill,
                                     cnc::gcode::PrintGrid grid,
                                     const std::vector<std::string>& heading,
                                     std::optional<double> ramp_slope = {});

}  // namespace sim::surface

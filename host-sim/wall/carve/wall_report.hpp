#pragma once

#include <string>
#include <vector>

#include "host-sim/wall/carve/columns.hpp"
#include "host-sim/wall/carve/drawn_walls.hpp"
#include "host-sim/wall/carve/wall_lean.hpp"

namespace sim::wall {

/// Report on the walls of a part, measured in one or two carved blocks.
struct WallReport {
  std::string text;  ///< A line with a heading, and a line for each wall.

  /// Comparison of the walls of a carved block with the drawn walls.
  struct Figures {
    std::size_t carved = 0;     ///< Number of measured walls.
    std::size_t missing = 0;    ///< Number of walls at which nothing was carved.
    double max_off_deg = 0.0;   ///< Greatest difference from the drawn angle, degrees.
    double mean_off_deg = 0.0;  ///< Mean signed difference from the drawn angle, degrees.
  };
  std::vector<Figures> figures;  ///< Figures of each block, in the order of the blocks.
};

/// Measures all walls in each block and reports them.
[[nodiscard]] WallReport report_walls(const std::vector<DrawnWall>& walls,
                                      const std::vector<const Columns*>& blocks);

}  // namespace sim::wall

#pragma once

#include <string>
#include <vector>

#include "host-sim/wall/carve/columns.hpp"
#include "host-sim/wall/carve/drawn_walls.hpp"
#include "host-sim/wall/carve/wall_lean.hpp"

namespace sim::wall {

/// Walls of a part, measured in one or two carved blocks.
struct WallReport {
  std::string text;  ///< A heading, and a line for each wall.

  /// Comparison of a carved block's walls with the drawn ones.
  struct Figures {
    std::size_t carved = 0;     ///< Number of walls that can be measured.
    std::size_t missing = 0;    ///< Number of walls at which nothing was carved.
    double max_off_deg = 0.0;   ///< Greatest difference from the drawn angle.
    double mean_off_deg = 0.0;  ///< Mean difference from the drawn angle, with its sign.
  };
  std::vector<Figures> figures;  ///< Figures of each block.
};

/// Measures all walls in each block and reports them.
[[nodiscard]] WallReport report_walls(const std::vector<DrawnWall>& walls,
                                      const std::vector<const Columns*>& blocks);

}  // namespace sim::wall

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/wall/carve/columns.hpp"
#include "host-sim/wall/carve/wall_lean.hpp"

namespace sim::wall {

/// A wall of a part, and the heights between which it is measured.
struct DrawnWall {
  WallPlace place;
  double angle_deg = 0.0;  ///< Angle from the vertical, degrees; > 0 if the part is wider below.
};

/// Limits of the search for walls.
struct WallSearch {
  double low_mm = 0.0;    ///< Height of the lowest tip.
  double high_mm = 0.0;   ///< Height of the stock's top.
  double cell_mm = 0.0;   ///< Side length of a column.
  double burn_deg = 0.0;  ///< Maximum angle between a carved wall and the drawn wall.
};

/// Returns the walls of a part that lean by at most 45 degrees, in the order of the part's facets.
/// All facets of a plane belong to one wall. A wall is measured at its largest facet, over the
/// middle 80 % of its height within the limits of the search. Walls with a height of less than five
/// cells within the limits are left out.
[[nodiscard]] std::vector<DrawnWall> drawn_walls(const surface::Mesh& part,
                                                 const WallSearch& search);

}  // namespace sim::wall

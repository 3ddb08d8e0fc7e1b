#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/wall/carve/columns.hpp"
#include "host-sim/wall/carve/wall_lean.hpp"

namespace sim::wall {

/// A wall of a part, between the depths at which it can be measured.
struct DrawnWall {
  WallPlace place;
  double angle_deg = 0.0;  ///< From the vertical; above 0 where the part is wider below.
};

/// How walls are looked for.
struct WallSearch {
  double low_mm = 0.0;    ///< Height of the lowest tip.
  double high_mm = 0.0;   ///< Height of the stock's top.
  double cell_mm = 0.0;   ///< Side of a column.
  double burn_deg = 0.0;  ///< By which a carved wall leans off the drawn one, at most.
};

/// Returns the walls of a part that lean by no more than 45 degrees, facets of one plane as one,
/// in the order of the part's facets. A wall is measured at its largest facet, over the middle 80 %
/// of its height within the search; walls lower than five cells there are left out.
[[nodiscard]] std::vector<DrawnWall> drawn_walls(const surface::Mesh& part,
                                                 const WallSearch& search);

}  // namespace sim::wall

#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/crease_finder.hpp"

namespace sim::surface {

/// A line along a valley; a closed one ends where it begins.
using CreaseLine = std::vector<CreasePlace>;

/// Returns the lines along all creases over a mesh, found on the edges of a square grid and joined
/// from cell to cell. A gap of up to two cells is bridged. Two valleys nearer to each other than
/// the pitch may be missed.
/// @param pitch_mm of the grid, above 0
[[nodiscard]] std::vector<CreaseLine> crease_lines(const Mesh& mesh,
                                                   const CreaseFinder& finder,
                                                   double pitch_mm);

}  // namespace sim::surface

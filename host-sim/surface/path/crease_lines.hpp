#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/crease_finder.hpp"

namespace sim::surface {

/// A line along a valley; a closed line ends where it begins.
using CreaseLine = std::vector<CreasePlace>;

/// Returns the lines along all creases over a mesh. Creases are found on the edges of a square grid
/// and joined from cell to cell. Gaps of up to two cells are bridged. If two valleys are nearer to
/// each other than the pitch, one may be missed.
/// @param pitch_mm pitch of the grid, above 0
[[nodiscard]] std::vector<CreaseLine> crease_lines(const Mesh& mesh,
                                                   const CreaseFinder& finder,
                                                   double pitch_mm);

}  // namespace sim::surface

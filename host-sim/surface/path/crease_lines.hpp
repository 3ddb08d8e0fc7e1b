#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/crease_finder.hpp"

namespace sim::surface {

/// Points along a valley. A closed line ends at its first point.
using CreaseLine = std::vector<CreasePlace>;

/// Returns the lines along all creases over a mesh. Crossings of creases with the edges of a square
/// grid are joined from cell to cell. Gaps of up to two cells are bridged. If the distance between
/// two valleys is less than the pitch, a valley may be missed.
/// @param pitch_mm pitch of the grid, above 0
[[nodiscard]] std::vector<CreaseLine> crease_lines(const Mesh& mesh,
                                                   const CreaseFinder& finder,
                                                   double pitch_mm);

}  // namespace sim::surface

#pragma once

#include <cstddef>
#include <string>

#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// Maximum number of columns in the file of a carved body; finer columns are thinned out.
inline constexpr std::size_t kMaxMeshColumns = 250'000;

/// Writes the material that is left as a closed body of upright bars: binary PLY if the name ends
/// in `.ply`, else binary STL. Throws std::system_error with the name of the file.
void write_carved(const std::string& file, const Columns& columns);

}  // namespace sim::wall

#pragma once

#include <cstddef>
#include <string>

#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// Maximum number of columns in a file. If there are more columns, only some of them are used.
inline constexpr std::size_t kMaxMeshColumns = 250'000;

/// Writes the remaining material as a closed body of upright bars. The file is binary PLY if its
/// name ends in `.ply`, else binary STL. Throws std::system_error with the name of the file.
void write_carved(const std::string& file, const Columns& columns);

}  // namespace sim::wall

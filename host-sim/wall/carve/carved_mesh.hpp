#pragma once

#include <cstddef>
#include <string>

#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// Columns that a file of a carved body shows, at most; finer ones are thinned.
inline constexpr std::size_t kMostMeshColumns = 250'000;

/// Writes what is left as a closed body of upright bars: binary PLY where the name ends in `.ply`,
/// else binary STL. Throws std::system_error naming the file.
void write_carved(const std::string& file, const Columns& columns);

}  // namespace sim::wall

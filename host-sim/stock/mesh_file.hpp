#pragma once

#include <cstddef>
#include <string>

#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// Points of the upper surface in a file, at most; finer stocks are thinned to blocks of cells.
inline constexpr std::size_t kMostMeshPoints = 500'000;

/// Writes the rest of a stock as a closed body: heights at the middles of cells or blocks,
/// carried to the stock's sides, and the sides and the bottom of the box below them. Where the
/// stock is cut through the surface lies on the bottom.
///
/// Binary STL, 50 bytes a triangle, or binary PLY (little-endian), 13 bytes a triangle and 12 a
/// point. Throws std::system_error naming the file.
void write_stl(const std::string& file, const Stock& stock);
void write_ply(const std::string& file, const Stock& stock);

}  // namespace sim::stock

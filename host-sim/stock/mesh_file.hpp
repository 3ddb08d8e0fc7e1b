#pragma once

#include <cstddef>
#include <string>

#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// Greatest number of points of the upper surface in a file. If a stock has more cells, blocks of
/// cells share a point.
inline constexpr std::size_t kMaxMeshPoints = 500'000;

/// Writes the material that is left of a stock as a closed body. The upper surface has a point at
/// the middle of each cell or block and is extended to the sides of the box. The sides and the
/// bottom of the box close the body. Where the stock is cut through, the upper surface is at the
/// bottom of the box.
///
/// write_stl() writes binary STL, with 50 bytes for each triangle. write_ply() writes binary PLY
/// (little-endian), with 13 bytes for each triangle and 12 for each point. Both throw
/// std::system_error with the name of the file.
void write_stl(const std::string& file, const Stock& stock);
void write_ply(const std::string& file, const Stock& stock);

}  // namespace sim::stock

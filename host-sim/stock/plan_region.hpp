#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host-sim/stock/distance_map.hpp"
#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// A closed line of straight pieces in the plan, machine coordinates, mm; the last point is joined
/// to the first.
using Ring = std::vector<std::array<double, 2>>;

enum class RegionPart : std::uint8_t { kOutside, kEdge, kInside };

/// Which cells of a stock are inside of rings, outside, or cut by one. Inside is where an odd
/// number of rings is around, so a ring in another is an island.
///
/// The grid is that of the stock's cells, over the box of the rings and a cell more at each side,
/// beyond the stock's sides, too.
class PlanRegion {
 public:
  PlanRegion(const std::vector<Ring>& rings, const Stock& stock);

  [[nodiscard]] const DistanceGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<RegionPart>& parts() const { return parts_; }
  /// Of a cell of the stock; beyond the grid all is outside.
  [[nodiscard]] RegionPart part_of(int column, int row) const;
  /// Whether the grid has a cell of the stock, and its index there.
  [[nodiscard]] bool has(int column, int row) const;
  [[nodiscard]] std::size_t index_of(int column, int row) const {
    return grid_.index(column - first_column_, row - first_row_);
  }

 private:
  void fit_to(const std::vector<Ring>& rings);
  void fill_row(const std::vector<Ring>& rings, int row);
  void mark_edge(const std::array<double, 2>& from, const std::array<double, 2>& to);

  const Stock& stock_;
  DistanceGrid grid_;
  int first_column_ = 0;  ///< Of the grid, in cells of the stock; may be negative.
  int first_row_ = 0;
  std::vector<RegionPart> parts_;
};

}  // namespace sim::stock

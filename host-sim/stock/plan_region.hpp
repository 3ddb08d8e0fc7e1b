#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host-sim/stock/distance_map.hpp"
#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// A closed line of straight pieces in plan, machine coordinates, mm. The last point is joined to
/// the first.
using Ring = std::vector<std::array<double, 2>>;

enum class RegionPart : std::uint8_t { kOutside, kEdge, kInside };

/// Classifies the cells of a stock as inside of rings, outside of rings, or crossed by a ring. A
/// point is inside if an odd number of rings encloses it. So a ring within another ring is an
/// island.
///
/// The grid has the same cells as the stock. It covers the bounding box of the rings and one more
/// cell on each side, even beyond the stock's sides.
class PlanRegion {
 public:
  PlanRegion(const std::vector<Ring>& rings, const Stock& stock);

  [[nodiscard]] const DistanceGrid& grid() const { return grid_; }
  [[nodiscard]] const std::vector<RegionPart>& parts() const { return parts_; }
  /// Returns whether a cell of the stock is outside, at an edge or inside. A cell beyond the grid
  /// is outside.
  [[nodiscard]] RegionPart part_of(int column, int row) const;
  /// has() returns whether the grid contains a cell of the stock. index_of() returns the index of a
  /// contained cell.
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
  int first_column_ = 0;  ///< Column of the stock at which the grid begins; may be negative.
  int first_row_ = 0;
  std::vector<RegionPart> parts_;
};

}  // namespace sim::stock

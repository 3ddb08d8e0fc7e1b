#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// Heights of a stock for display, over equal blocks of cells. Each height is the mean over the
/// cells of a block. A cell's height is the mean of its two bounds. Blocks at the upper ends of X
/// and Y may have fewer cells.
class HeightMap {
 public:
  /// @param max_blocks greatest number of blocks, > 0. It determines the number of cells along a
  ///     block's side
  HeightMap(const Stock& stock, std::size_t max_blocks);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  /// Returns the number of cells along each side of a block.
  [[nodiscard]] int block_cells() const { return block_cells_; }
  /// Returns the height of a block, mm, machine coordinates.
  [[nodiscard]] double height(int column, int row) const {
    return heights_mm_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                       static_cast<std::size_t>(column)];
  }
  [[nodiscard]] double lowest() const;
  /// x_of() and y_of() return the coordinates of the middle of a block.
  [[nodiscard]] double x_of(int column) const;
  [[nodiscard]] double y_of(int row) const;
  [[nodiscard]] const StockBox& box() const { return stock_.box(); }

 private:
  [[nodiscard]] int cells_in(int block, int cells) const;
  void add_row(int row);

  const Stock& stock_;
  int block_cells_;
  int columns_;
  int rows_;
  std::vector<double> heights_mm_;
};

}  // namespace sim::stock

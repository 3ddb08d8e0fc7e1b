#include "host-sim/stock/height_map.hpp"

#include <algorithm>
#include <cmath>

namespace sim::stock {
namespace {

int blocks_of(int cells, int block_cells) { return (cells + block_cells - 1) / block_cells; }

/// Returns the smallest number of cells along a block's side for which there are at most
/// `max_blocks` blocks.
int block_for(const Stock& stock, std::size_t max_blocks) {
  const auto blocks = [&stock](int block_cells) {
    return static_cast<std::size_t>(blocks_of(stock.columns(), block_cells)) *
           static_cast<std::size_t>(blocks_of(stock.rows(), block_cells));
  };
  int block_cells = 1;
  while (blocks(block_cells) > std::max<std::size_t>(max_blocks, 1)) ++block_cells;
  return block_cells;
}

}  // namespace

HeightMap::HeightMap(const Stock& stock, std::size_t max_blocks)
    : stock_{stock},
      block_cells_{block_for(stock, max_blocks)},
      columns_{blocks_of(stock.columns(), block_cells_)},
      rows_{blocks_of(stock.rows(), block_cells_)},
      heights_mm_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0.0) {
  for (int row = 0; row < stock.rows(); ++row) add_row(row);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const double cells = 1.0 * cells_in(column, stock.columns()) * cells_in(row, stock.rows());
      double& height =
          heights_mm_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(column)];
      height = stock.box().top + height / (cells * kNmPerMm);
    }
  }
}

int HeightMap::cells_in(int block, int cells) const {
  return std::min(block_cells_, cells - block * block_cells_);
}

/// Adds the mean heights of a row of cells, in nanometres above the top, to the sums of their
/// blocks.
void HeightMap::add_row(int row) {
  double* const sums = &heights_mm_[static_cast<std::size_t>(row / block_cells_) *
                                    static_cast<std::size_t>(columns_)];
  for (int tile = 0; tile < stock_.tile_columns(); ++tile) {
    const Cell* cells = stock_.touched_row_of_tile(tile, row);
    if (cells == nullptr) continue;
    const int first = tile * Stock::kTileCells;
    const int end = std::min(first + Stock::kTileCells, stock_.columns());
    for (int column = first; column < end; ++column) {
      const Cell& cell = cells[column - first];
      sums[column / block_cells_] += 0.5 * (1.0 * cell.lower_nm + cell.upper_nm);
    }
  }
}

double HeightMap::lowest() const { return *std::ranges::min_element(heights_mm_); }

double HeightMap::x_of(int column) const {
  const double cells = column * block_cells_ + 0.5 * cells_in(column, stock_.columns());
  return box().x_min + cells * stock_.cell_x_mm();
}

double HeightMap::y_of(int row) const {
  const double cells = row * block_cells_ + 0.5 * cells_in(row, stock_.rows());
  return box().y_min + cells * stock_.cell_y_mm();
}

}  // namespace sim::stock

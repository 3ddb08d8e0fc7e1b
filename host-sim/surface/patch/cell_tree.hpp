#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sim::surface::patch {

/// A rectangle of quadrilaterals of a grid, given by the rows and columns of its corners.
struct Cell {
  std::uint32_t row = 0;
  std::uint32_t column = 0;
  std::uint32_t end_row = 0;
  std::uint32_t end_column = 0;
  std::uint32_t depth = 0;  ///< Number of splits from the complete grid to this cell.

  [[nodiscard]] std::uint32_t height() const { return end_row - row; }
  [[nodiscard]] std::uint32_t width() const { return end_column - column; }
  [[nodiscard]] bool can_be_split() const { return height() > 1 || width() > 1; }
  [[nodiscard]] bool has_corner(std::uint32_t at_row, std::uint32_t at_column) const {
    return (at_row == row || at_row == end_row) && (at_column == column || at_column == end_column);
  }
};

/// The cells of an adaptive subdivision of a grid. The subdivision starts with one cell and splits
/// cells in four at the middle row and column. A cell of one row or column is split in two.
/// Neighbours across a border differ by at most one split, so that a coarse patch does not
/// constrain many fine patches.
///
/// A hanging corner is a corner of a cell that is inside a border of another cell. The other cell
/// then has fewer splits. The border of a coarse cell contains the complete borders of its finer
/// neighbours, because all cells of a depth are divided at the same rows and columns.
class CellTree {
 public:
  /// @pre rows and columns of points are at least two
  CellTree(std::size_t rows, std::size_t columns);

  /// Returns all cells; the index of a cell is its number. Numbers do not change. The first part of
  /// a split cell gets the cell's number.
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  /// Returns the number of the cell that contains the quadrilateral between the point (`row`,
  /// `column`) and the next row and column.
  [[nodiscard]] std::uint32_t cell_at(std::uint32_t row, std::uint32_t column) const {
    return numbers_[std::size_t{row} * width_ + column];
  }
  /// Returns the numbers of the cells that contain a point in their interior or on their border. A
  /// number may occur several times.
  [[nodiscard]] std::vector<std::uint32_t> cells_around(std::uint32_t row,
                                                        std::uint32_t column) const;

  /// Splits a cell. First splits the neighbours that would differ from its parts by two splits.
  /// @pre the cell can be split
  void split(std::uint32_t number);

 private:
  void divide(std::uint32_t number);
  void add(const Cell& cell, std::uint32_t number);
  [[nodiscard]] std::vector<std::uint32_t> coarser_neighbours(const Cell& cell) const;

  std::uint32_t height_ = 0;  ///< Number of quadrilaterals in a column.
  std::uint32_t width_ = 0;   ///< Number of quadrilaterals in a row.
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> numbers_;  ///< Cell number of each quadrilateral, row by row.
};

}  // namespace sim::surface::patch

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sim::stock {

/// The uncut block: an upright box in machine coordinates, mm.
struct StockBox {
  double x_min = 0.0;
  double y_min = 0.0;
  double x_max = 0.0;
  double y_max = 0.0;
  double top = 0.0;
  double bottom = 0.0;
};

/// Greatest distance of a side of the stock from the origin.
inline constexpr double kFarthestStockMm = 100'000.0;
inline constexpr double kDeepestStockMm = 1'000.0;  ///< Greatest height of the stock.
inline constexpr double kMinCellMm = 0.001;
inline constexpr double kGreatestCellMm = 10.0;
/// Greatest number of cells of a stock. The table of tiles takes 8 bytes for each 4,096 cells.
inline constexpr double kMaxCells = 1.0e10;
/// Greatest memory for carved cells, bytes. Each cell takes 8 bytes.
inline constexpr std::size_t kMaxCarvedBytes = std::size_t{4} << 30;

/// Returns the reason, with range and unit, why a stock is not possible; empty if the stock is
/// possible.
[[nodiscard]] std::string fault_of(const StockBox& box, double cell_mm);

inline constexpr double kNmPerMm = 1.0e6;

/// Bounds of the stock's height over every point of a cell. Heights are nanometres above the top of
/// the uncut stock, so they are at most 0.
struct Cell {
  std::int32_t lower_nm = 0;
  std::int32_t upper_nm = 0;
};

/// Bounds of a volume.
struct VolumeBounds {
  double min_mm3 = 0.0;
  double max_mm3 = 0.0;
};

/// The material that is left of a block, as one height over each point of its plan.
///
/// Cells are equal rectangles that divide the sides and are no longer than `cell_mm`. Untouched
/// cells take no memory: a tile of 64 by 64 cells is allocated when one of its cells is changed.
/// Each tile takes 32 KiB. With cells of 0.05 mm, the tiles take 3.2 MB for each 10 cm² that the
/// tool has touched.
class Stock {
 public:
  static constexpr int kTileCells = 64;  ///< Number of cells along each side of a tile.

  /// @pre fault_of(box, cell_mm) is empty
  Stock(const StockBox& box, double cell_mm);

  [[nodiscard]] const StockBox& box() const { return box_; }
  [[nodiscard]] int columns() const { return columns_; }  ///< Returns the number of cells along X.
  [[nodiscard]] int tile_columns() const { return tile_columns_; }
  [[nodiscard]] int rows() const { return rows_; }  ///< Returns the number of cells along Y.
  [[nodiscard]] double cell_x_mm() const { return cell_x_mm_; }
  [[nodiscard]] double cell_y_mm() const { return cell_y_mm_; }
  [[nodiscard]] std::int32_t bottom_nm() const { return bottom_nm_; }

  /// Returns a cell. @pre 0 <= column < columns(), 0 <= row < rows()
  [[nodiscard]] const Cell& cell(int column, int row) const;

  /// Returns the cell that contains the point (x, y), mm; null outside of the stock. The pointer is
  /// valid until the next call of row_of_tile().
  [[nodiscard]] const Cell* cell_at(double x, double y) const;

  /// Returns a pointer to the cells of `row` in a tile, beginning with the tile's first column;
  /// null if the tile is untouched.
  [[nodiscard]] const Cell* touched_row_of_tile(int tile_column, int row) const;

  /// Returns a pointer to the cells of `row` in a tile, beginning with the tile's first column, for
  /// changes. Allocates the tile if necessary. Throws std::runtime_error if carved cells would take
  /// more than kMaxCarvedBytes.
  [[nodiscard]] Cell* row_of_tile(int tile_column, int row);

  /// Counts removed material. The parameters are the amounts, summed over the changed cells, by
  /// which upper and lower bounds were lowered.
  void count_removed(std::int64_t upper_fell_nm, std::int64_t lower_fell_nm) {
    upper_fell_nm_ += upper_fell_nm;
    lower_fell_nm_ += lower_fell_nm;
  }
  [[nodiscard]] VolumeBounds removed() const;

  /// Returns the memory of the allocated tiles, bytes.
  [[nodiscard]] std::size_t carved_bytes() const { return tiles_in_use_ * sizeof(Tile); }

 private:
  using Tile = std::array<Cell, std::size_t{kTileCells} * kTileCells>;

  [[nodiscard]] std::size_t tile_of(int tile_column, int row) const {
    return static_cast<std::size_t>(row / kTileCells) * static_cast<std::size_t>(tile_columns_) +
           static_cast<std::size_t>(tile_column);
  }

  StockBox box_;
  int columns_;
  int rows_;
  int tile_columns_;
  double cell_x_mm_;
  double cell_y_mm_;
  std::int32_t bottom_nm_;
  std::vector<std::unique_ptr<Tile>> tiles_;  ///< A tile is null if none of its cells was touched.
  std::size_t tiles_in_use_ = 0;
  std::int64_t upper_fell_nm_ = 0;
  std::int64_t lower_fell_nm_ = 0;
};

}  // namespace sim::stock

#include "host-sim/stock/stock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sim::stock {
namespace {

std::string fault_of_side(char axis, double low, double high) {
  // The negated condition also refuses NaN.
  if (!(std::abs(low) <= kFarthestStockMm && std::abs(high) <= kFarthestStockMm)) {
    return fmt::format("{} of the stock is {} to {} mm; it must be within {} to {} mm",
                       axis,
                       low,
                       high,
                       -kFarthestStockMm,
                       kFarthestStockMm);
  }
  if (low < high) return {};
  return fmt::format(
      "{} of the stock is {} to {} mm; the second number must be greater", axis, low, high);
}

double cells_along(double length_mm, double cell_mm) {
  // Tolerance of the quotient, so that rounding does not add a cell: 10 mm are 200 cells of 0.05
  // mm.
  constexpr double kRounding = 1.0e-9;
  return std::max(1.0, std::ceil(length_mm / cell_mm - kRounding));
}

}  // namespace

std::string fault_of(const StockBox& box, double cell_mm) {
  for (const std::string& fault : {fault_of_side('X', box.x_min, box.x_max),
                                   fault_of_side('Y', box.y_min, box.y_max),
                                   fault_of_side('Z', box.bottom, box.top)}) {
    if (!fault.empty()) return fault;
  }
  if (box.top - box.bottom > kDeepestStockMm) {
    return fmt::format("the stock is {} mm high; at most {} mm are possible",
                       box.top - box.bottom,
                       kDeepestStockMm);
  }
  if (!(cell_mm >= kMinCellMm && cell_mm <= kGreatestCellMm)) {
    return fmt::format("the stock's cells are {} mm; they must be {} to {} mm",
                       cell_mm,
                       kMinCellMm,
                       kGreatestCellMm);
  }
  const double cells =
      cells_along(box.x_max - box.x_min, cell_mm) * cells_along(box.y_max - box.y_min, cell_mm);
  if (cells <= kMaxCells) return {};
  return fmt::format(
      "the stock has {:.3g} cells of {} mm; at most {:.3g} are possible, so choose larger cells",
      cells,
      cell_mm,
      kMaxCells);
}

Stock::Stock(const StockBox& box, double cell_mm)
    : box_{box},
      columns_{static_cast<int>(cells_along(box.x_max - box.x_min, cell_mm))},
      rows_{static_cast<int>(cells_along(box.y_max - box.y_min, cell_mm))},
      tile_columns_{(columns_ + kTileCells - 1) / kTileCells},
      cell_x_mm_{(box.x_max - box.x_min) / columns_},
      cell_y_mm_{(box.y_max - box.y_min) / rows_},
      bottom_nm_{static_cast<std::int32_t>(std::lround((box.bottom - box.top) * kNmPerMm))} {
  tiles_.resize(tile_of(0, rows_ - 1) + static_cast<std::size_t>(tile_columns_));
}

const Cell& Stock::cell(int column, int row) const {
  static constexpr Cell kUntouched{};
  const auto& tile = tiles_[tile_of(column / kTileCells, row)];
  if (!tile) return kUntouched;
  const auto row_in_tile = static_cast<std::size_t>(row % kTileCells);
  return (*tile)[row_in_tile * kTileCells + static_cast<std::size_t>(column % kTileCells)];
}

const Cell* Stock::cell_at(double x, double y) const {
  const double column = (x - box_.x_min) / cell_x_mm_;
  const double row = (y - box_.y_min) / cell_y_mm_;
  if (!(column >= 0.0 && column < columns_ && row >= 0.0 && row < rows_)) return nullptr;
  return &cell(static_cast<int>(column), static_cast<int>(row));
}

const Cell* Stock::touched_row_of_tile(int tile_column, int row) const {
  const auto& tile = tiles_[tile_of(tile_column, row)];
  if (!tile) return nullptr;
  return tile->data() + static_cast<std::ptrdiff_t>(row % kTileCells) * kTileCells;
}

Cell* Stock::row_of_tile(int tile_column, int row) {
  auto& tile = tiles_[tile_of(tile_column, row)];
  if (!tile) {
    if (carved_bytes() + sizeof(Tile) > kMaxCarvedBytes) {
      throw std::runtime_error(fmt::format(
          "the carved stock takes more than {} GiB; choose larger cells", kMaxCarvedBytes >> 30));
    }
    tile = std::make_unique<Tile>();
    ++tiles_in_use_;
  }
  return tile->data() + static_cast<std::ptrdiff_t>(row % kTileCells) * kTileCells;
}

VolumeBounds Stock::removed() const {
  const double mm3_per_nm = cell_x_mm_ * cell_y_mm_ / kNmPerMm;
  return {static_cast<double>(upper_fell_nm_) * mm3_per_nm,
          static_cast<double>(lower_fell_nm_) * mm3_per_nm};
}

}  // namespace sim::stock

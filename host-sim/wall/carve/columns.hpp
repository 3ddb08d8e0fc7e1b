#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/stock/stock.hpp"
#include "host-sim/wall/carve/swept_cone.hpp"

namespace sim::wall {

/// Maximum number of bytes for the columns of a stock.
inline constexpr std::size_t kMaxColumnBytes = std::size_t{1} << 30;

/// A block as upright columns at the middles of equal cells. Each column consists of the ranges of
/// heights with remaining material, so that hollows below material are possible. A column takes 24
/// bytes, and each range after the first range takes 24 more.
class Columns {
 public:
  /// Returns the reason, with a remedy, why a block cannot be represented by columns of this cell
  /// size; empty if it can.
  [[nodiscard]] static std::string fault_of(const stock::StockBox& box, double cell_mm);

  /// Creates the columns of an uncut block, whose sides are divided into equal cells no longer than
  /// `cell_mm`.
  /// @pre fault_of(box, cell_mm) is empty
  Columns(const stock::StockBox& box, double cell_mm);

  [[nodiscard]] const stock::StockBox& box() const { return box_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double cell_x_mm() const { return cell_x_mm_; }
  [[nodiscard]] double cell_y_mm() const { return cell_y_mm_; }
  [[nodiscard]] double x_of(int column) const { return box_.x_min + (column + 0.5) * cell_x_mm_; }
  [[nodiscard]] double y_of(int row) const { return box_.y_min + (row + 0.5) * cell_y_mm_; }
  [[nodiscard]] std::size_t bytes() const { return spans_.capacity() * sizeof(Span); }

  /// Returns the height of a column's highest remaining point; minus infinity if nothing remains.
  [[nodiscard]] double top(int column, int row) const { return head(column, row).high; }

  /// Removes all heights of a range from a column. Throws std::length_error if the columns need
  /// more than kMaxColumnBytes.
  void remove(int column, int row, const HeightRange& range);

  /// Calls `visit(range)` for each remaining range of a column, from the highest range downwards.
  template <typename Visit>
  void each_range(int column, int row, Visit visit) const {
    const Span* span = &head(column, row);
    if (span->low >= span->high) return;
    while (true) {
      visit(HeightRange{span->low, span->high});
      if (span->below == kNone) return;
      span = &spans_[span->below];
    }
  }

  /// Returns whether a column has material at the height `z`.
  [[nodiscard]] bool has(int column, int row, double z) const;

 private:
  using Index = std::uint32_t;
  static constexpr Index kNone = 0xffff'ffff;

  /// A remaining range, and the index of the next range below it. An empty column has one range
  /// from 0 to minus infinity.
  struct Span {
    double low = 0.0;
    double high = 0.0;
    Index below = kNone;
  };

  [[nodiscard]] std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] const Span& head(int column, int row) const {
    return spans_[index_of(column, row)];
  }
  [[nodiscard]] Index add(const Span& span);
  void split(std::size_t at, const HeightRange& range);
  void erase(std::size_t at, std::size_t above);

  stock::StockBox box_;
  int columns_;
  int rows_;
  double cell_x_mm_;
  double cell_y_mm_;
  /// All ranges: first the highest range of each column, then all other ranges.
  std::vector<Span> spans_;
  std::vector<Index> free_;  ///< Indices of unused entries of spans_.
};

}  // namespace sim::wall

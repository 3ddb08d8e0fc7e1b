#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/xyz_table.hpp"

namespace sim::surface {

/// Points of a table that form one row of the scan.
struct ScanRow {
  std::size_t begin = 0;
  std::size_t end = 0;     ///< Index behind the last point.
  bool is_turned = false;  ///< The scan ran along it against the row before.

  [[nodiscard]] std::size_t size() const { return end - begin; }
  /// Returns the index of the point at `column` of the row, in the direction of the first row.
  [[nodiscard]] std::size_t index(std::size_t column) const {
    return is_turned ? end - 1 - column : begin + column;
  }
};

/// Divides the points into rows: at blank lines where there are any, else where the scan turns.
///
/// A scan turns where its step runs against the row, or more sideways than along the direction of
/// all rows: that of the first step, and then that of the longest row found so. So rows that all
/// run forward are found, and rows of a serpentine, whose every other row is marked as turned. Bent
/// rows need blank lines.
[[nodiscard]] std::vector<ScanRow> rows_of(const XyzTable& table);

}  // namespace sim::surface

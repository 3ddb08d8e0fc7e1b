#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/xyz_table.hpp"

namespace sim::surface {

/// Points of a table that form one row of the scan.
struct ScanRow {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< Index after the last point.
  /// Whether the scan ran along this row against the direction of the first row.
  bool is_turned = false;

  [[nodiscard]] std::size_t size() const { return end - begin; }
  /// Returns the index of the point at `column`, counted in the direction of the first row.
  [[nodiscard]] std::size_t index(std::size_t column) const {
    return is_turned ? end - 1 - column : begin + column;
  }
};

/// Divides the points into rows: at blank lines if there are any, else where the scan turns.
///
/// A scan turns where its step runs against its row, or more sideways than along the direction of
/// all rows. That direction is first the one of the first step, then the one of the longest row
/// found with it. This finds rows that all run forward, and rows of a serpentine, in which every
/// other row is marked as turned. Curved rows need blank lines.
[[nodiscard]] std::vector<ScanRow> rows_of(const XyzTable& table);

}  // namespace sim::surface

#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/xyz_table.hpp"

namespace sim::surface {

/// Range of the points of a table that form a row of the scan.
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

/// Divides the points into rows: at blank lines if there are any, else where a new row of the scan
/// begins.
///
/// A new row begins where a step reverses the row's sense, or goes more across than along the
/// direction of the rows. The direction of the rows is first estimated by the first step, then by
/// the longest row. The method finds rows that all run forward. It also finds the rows of a
/// serpentine and marks every second row as turned. Curved rows need blank lines.
[[nodiscard]] std::vector<ScanRow> rows_of(const XyzTable& table);

}  // namespace sim::surface

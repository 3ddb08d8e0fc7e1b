#pragma once

#include <cstdint>
#include <vector>

#include "planner/pocket/tool_path.hpp"

namespace sim::pocket {

/// Rows of a tool path with their storage. path() returns them as a ToolPathView.
struct PathRows {
  std::vector<cnc::pocket::PathPoint<double>> points;
  std::vector<std::uint32_t> row_ends;  ///< For each row, one past the index of its last point.

  [[nodiscard]] cnc::pocket::ToolPathView<double> path() const {
    return {{points.data(), points.size()}, {row_ends.data(), row_ends.size()}};
  }

  /// Ends the row that is being written. Does nothing if that row has no point.
  void end_row();

  /// Appends the rows of another path, moved up by `up_mm`.
  void append(const PathRows& rows, double up_mm = 0.0);
};

}  // namespace sim::pocket

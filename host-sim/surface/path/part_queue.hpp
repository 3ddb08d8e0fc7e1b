#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/path/row_frame.hpp"

namespace sim::surface {

/// A queue of the parts of rows that are still to be milled, from which the nearest part can be
/// taken. A search begins at the row of the tool and continues to both sides, so that near parts
/// are found quickly.
class PartQueue {
 public:
  struct Next {
    RowPart part;
    bool goes_back = false;  ///< Whether the part is driven from its end to its start.
  };

  explicit PartQueue(std::vector<RowPart> parts);

  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// Removes and returns the part whose start is nearest to a point. If `may_go_back`, the end of a
  /// part is considered, too.
  /// @param seen coordinates of the point along and across the rows, mm
  /// @pre not empty
  Next take_nearest(const Eigen::Vector2d& seen, bool may_go_back);
  /// Removes and returns the first part of the lowest row, or of the highest row if `is_highest`.
  /// @pre not empty
  Next take_outermost(bool is_highest);

 private:
  /// The nearest start or end of a part that a search has found.
  struct Found {
    std::size_t index = 0;
    double distance = 0.0;
    bool goes_back = false;
  };

  [[nodiscard]] std::size_t waiting_from(std::size_t index);
  [[nodiscard]] std::size_t waiting_before(std::size_t index);
  void consider(std::size_t index, const Eigen::Vector2d& seen, bool may_go_back, Found& found);
  Next take(std::size_t index, bool goes_back);

  std::vector<RowPart> parts_;  ///< All parts, sorted by row, then by position along the row.
  /// Link of each part towards the next waiting part above it; the part's own index if the part
  /// waits.
  std::vector<std::size_t> above_;
  /// Link of each part towards the next waiting part below it. Entries are indices plus one; 0
  /// means that there is no part.
  std::vector<std::size_t> below_;
  std::size_t count_;
};

}  // namespace sim::surface

#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/path/row_frame.hpp"

namespace sim::surface {

/// Parts of rows that are still to be milled; the nearest part is taken next. A search begins at
/// the row of the last place and continues to both sides, so that near parts are found quickly.
class PartQueue {
 public:
  struct Next {
    RowPart part;
    bool goes_back = false;  ///< Whether the part is driven from its end to its begin.
  };

  explicit PartQueue(std::vector<RowPart> parts);

  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// Takes the part whose begin is nearest to a place. If `may_go_back`, the end of a part counts,
  /// too.
  /// @param seen the place along and across the rows, mm
  /// @pre not empty
  Next take_nearest(const Eigen::Vector2d& seen, bool may_go_back);
  /// Takes the first part of the lowest row, or of the highest row if `is_highest`.
  /// @pre not empty
  Next take_outermost(bool is_highest);

 private:
  /// The nearest end that a search has found.
  struct Found {
    std::size_t index = 0;
    double distance = 0.0;
    bool goes_back = false;
  };

  [[nodiscard]] std::size_t waiting_from(std::size_t index);
  [[nodiscard]] std::size_t waiting_before(std::size_t index);
  void consider(std::size_t index, const Eigen::Vector2d& seen, bool may_go_back, Found& found);
  Next take(std::size_t index, bool goes_back);

  std::vector<RowPart> parts_;  ///< Parts sorted by row, then along the row.
  /// For each part an index from which the next waiting part is found; its own index if the part
  /// waits.
  std::vector<std::size_t> above_;
  /// The same in the other direction; an entry is the part's index plus one, 0 for none.
  std::vector<std::size_t> below_;
  std::size_t count_;
};

}  // namespace sim::surface

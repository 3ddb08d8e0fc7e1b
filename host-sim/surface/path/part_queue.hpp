#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/path/row_frame.hpp"

namespace sim::surface {

/// Parts of rows that are still to be milled, from which the nearest is taken next. A search begins
/// at the row of the last place and goes on to both sides, so that near parts are found at once.
class PartQueue {
 public:
  struct Next {
    RowPart part;
    bool goes_back = false;  ///< The end of the part is where it begins.
  };

  explicit PartQueue(std::vector<RowPart> parts);

  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// Takes the part whose begin, or end if it may go back, is nearest to a place.
  /// @param seen the place along and across the rows, mm @pre not empty
  Next take_nearest(const Eigen::Vector2d& seen, bool may_go_back);
  /// Takes the first part of the lowest row, or of the highest. @pre not empty
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

  std::vector<RowPart> parts_;      ///< By row, then along it.
  std::vector<std::size_t> above_;  ///< Where the next waiting part may be; itself if it waits.
  std::vector<std::size_t> below_;  ///< The same downwards, one more than the index; 0: none.
  std::size_t count_;
};

}  // namespace sim::surface

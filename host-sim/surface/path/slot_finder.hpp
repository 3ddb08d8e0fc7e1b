#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <vector>

#include "host-sim/pocket/stock_box.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Finds where a tool that goes through a level has stock on both sides. It marks cells of the plan
/// that the tool has been over, so that answers are good to an eighth of its radius.
class SlotFinder {
 public:
  /// @param box the stock, mm; beside it there is none
  /// @param radius_mm of the tool's disc, above 0
  SlotFinder(const pocket::StockBox& box, double radius_mm);

  /// Returns what an element in a level plane is, and takes the stock under the tool: a slot where
  /// stock is on both sides of any of its places, else a row.
  [[nodiscard]] StretchUse use_of(const ContourVertex& from, const ContourVertex& to);

  /// Ends a run: the next element does not begin where the last one ended.
  void end_run();

 private:
  [[nodiscard]] bool is_stock(const Eigen::Vector2d& place) const;
  void take(const Eigen::Vector2d& place);

  pocket::StockBox box_;
  double radius_mm_;
  double cell_mm_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<bool> is_taken_;
  /// Places of the tool of the last way of about a radius. They are taken later: the disc around a
  /// place also reaches ahead of it.
  std::deque<Eigen::Vector2d> last_;
};

}  // namespace sim::surface

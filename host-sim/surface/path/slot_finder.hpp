#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <vector>

#include "host-sim/pocket/stock_box.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Finds the parts of a path in a level at which a tool has stock on both sides. It marks the cells
/// of the plan that the tool has passed. A cell, and thus the error, is an eighth of the tool's
/// radius or larger.
class SlotFinder {
 public:
  /// @param box rectangle of the stock, mm
  /// @param radius_mm radius of the tool's disc, above 0
  SlotFinder(const pocket::StockBox& box, double radius_mm);

  /// Classifies an element in a level plane and removes the stock under the tool. Returns kSlot if
  /// stock is on both sides of any point of the element, else kRow.
  [[nodiscard]] StretchUse use_of(const ContourVertex& from, const ContourVertex& to);

  /// Ends a run. Must be called if the next element does not begin at the end of the last element.
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
  /// Last positions of the tool, over a distance of about its radius. Their stock is not removed
  /// yet, because the tool's disc also covers the stock ahead of the tool.
  std::deque<Eigen::Vector2d> last_;
};

}  // namespace sim::surface

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <vector>

#include "host-sim/pocket/stock_box.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Finds where a tool that moves through a level has stock on both sides. It marks the cells of the
/// plan that the tool has passed over, so that results are exact to an eighth of its radius.
class SlotFinder {
 public:
  /// @param box the stock, mm; there is no stock outside it
  /// @param radius_mm radius of the tool's disc, above 0
  SlotFinder(const pocket::StockBox& box, double radius_mm);

  /// Classifies an element in a level plane, and removes the stock under the tool. Returns a slot
  /// if stock is on both sides of any place of the element, else a row.
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
  /// The last places of the tool, over a distance of about its radius. Stock is removed there with
  /// a delay, because the disc around a place also reaches ahead of it.
  std::deque<Eigen::Vector2d> last_;
};

}  // namespace sim::surface

#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/stock_box.hpp"

namespace sim::surface {

/// Limits in the plan for the tool's tip: a rectangle, and drawn areas within it.
class LevelBorder {
 public:
  /// @param box the rectangle, mm
  /// @param drawn contours with their area on the left, of which any may hold the tip; none: all do
  /// @param inset_mm distance by which the tip stays within all of them, at least 0
  LevelBorder(const pocket::StockBox& box, const std::vector<Contour>& drawn, double inset_mm);

  /// Returns how far a place is beyond the limits, mm; negative within.
  [[nodiscard]] double beyond(const Eigen::Vector2d& place) const;
  [[nodiscard]] const pocket::StockBox& box() const { return box_; }

 private:
  pocket::StockBox box_;
  std::vector<std::unique_ptr<const pocket::OwnedArea>> drawn_;
  double inset_mm_;
};

}  // namespace sim::surface

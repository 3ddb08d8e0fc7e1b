#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/stock_box.hpp"

namespace sim::surface {

/// Limits in plan for the tool's tip: a rectangle, and drawn areas within it.
class LevelBorder {
 public:
  /// @param box the rectangle, mm
  /// @param drawn contours with their area on the left; the tip must be in at least one of them.
  /// With no contours the rectangle alone limits the tip.
  /// @param inset_mm distance by which the tip stays inside all limits, at least 0
  LevelBorder(const pocket::StockBox& box, const std::vector<Contour>& drawn, double inset_mm);

  /// Returns the distance in mm by which a place is beyond the limits; negative inside.
  [[nodiscard]] double beyond(const Eigen::Vector2d& place) const;
  [[nodiscard]] const pocket::StockBox& box() const { return box_; }

 private:
  pocket::StockBox box_;
  std::vector<std::unique_ptr<const pocket::OwnedArea>> drawn_;
  double inset_mm_;
};

}  // namespace sim::surface

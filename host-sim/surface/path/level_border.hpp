#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/stock_box.hpp"

namespace sim::surface {

/// Limits in plan for the tool's tip: a rectangle and, within it, drawn areas.
class LevelBorder {
 public:
  /// @param box the rectangle, mm
  /// @param drawn contours with their area on the left. The tip must be in at least one of the
  /// areas. Without contours, only the rectangle limits the tip.
  /// @param inset_mm minimum distance of the tip from all limits, at least 0
  LevelBorder(const pocket::StockBox& box, const std::vector<Contour>& drawn, double inset_mm);

  /// Returns the distance in mm by which `place` is beyond the limits; negative inside the limits.
  [[nodiscard]] double beyond(const Eigen::Vector2d& place) const;
  [[nodiscard]] const pocket::StockBox& box() const { return box_; }

 private:
  pocket::StockBox box_;
  std::vector<std::unique_ptr<const pocket::OwnedArea>> drawn_;
  double inset_mm_;
};

}  // namespace sim::surface

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "host-sim/wall/carve/swept_cone.hpp"

namespace sim::wall {

/// A convex area of the plan that encloses some discs: their hull, with a polygon around each.
class Footprint {
 public:
  explicit Footprint(const std::array<SweptCone::Disc, 4>& discs);

  /// Ends along X.
  struct Reach {
    double from = 0.0;
    double until = 0.0;
  };
  [[nodiscard]] double y_min() const { return y_min_; }
  [[nodiscard]] double y_max() const { return y_max_; }
  /// Returns the ends of the area among all points with this Y; nothing beside it.
  [[nodiscard]] std::optional<Reach> along(double y) const;

 private:
  std::vector<Eigen::Vector2d> corners_;  ///< Counter-clockwise.
  double y_min_ = 0.0;
  double y_max_ = 0.0;
};

}  // namespace sim::wall

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "host-sim/wall/carve/swept_cone.hpp"

namespace sim::wall {

/// A convex area in plan that encloses several discs: the hull of polygons around the discs.
class Footprint {
 public:
  explicit Footprint(const std::array<SweptCone::Disc, 4>& discs);

  /// Range of the area along X.
  struct Reach {
    double from = 0.0;
    double until = 0.0;
  };
  [[nodiscard]] double y_min() const { return y_min_; }
  [[nodiscard]] double y_max() const { return y_max_; }
  /// Returns the range of X of the area's points at `y`; nothing if the area has no points there.
  [[nodiscard]] std::optional<Reach> along(double y) const;

 private:
  std::vector<Eigen::Vector2d> corners_;  ///< Corners of the area in counter-clockwise order.
  double y_min_ = 0.0;
  double y_max_ = 0.0;
};

}  // namespace sim::wall

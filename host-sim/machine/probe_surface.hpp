#pragma once

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim {

/// A conducting surface under a probe whose tip is a ball, in machine coordinates, mm. It does not
/// change, so threads may share it.
class ProbeSurface {
 public:
  using Hint = surface::DropCutter::Hint;

  /// Radius in mm of the ball that stands for a tip of 0 mm. A true point would not be raised by a
  /// vertical wall; this ball is.
  static constexpr double kPointRadiusMm = 1.0e-5;

  /// Builds the surface.
  /// @param tip_mm diameter of the ball, ≥ 0
  /// @pre the mesh has a facet, and its indices are those of points
  ProbeSurface(const surface::Mesh& mesh, double tip_mm);

  /// Returns the height of the ball's lowest point at its first touch when it comes down along Z at
  /// this X and Y; cnc::surface::kNoContact where nothing is under the ball.
  [[nodiscard]] double tip_height(double x_mm, double y_mm, Hint& hint) const {
    return cutter_.tip_height({x_mm, y_mm}, hint);
  }
  /// Returns the height above which the ball touches nothing.
  [[nodiscard]] double top_mm() const { return top_mm_; }

 private:
  surface::DropCutter cutter_;
  double top_mm_;
};

}  // namespace sim

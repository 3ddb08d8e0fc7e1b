#pragma once

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim {

/// A conducting surface under a probe with a spherical tip, in machine coordinates, mm. It does not
/// change, so threads may share it.
class ProbeSurface {
 public:
  using Hint = surface::DropCutter::Hint;

  /// Radius of the ball that replaces a tip of 0 mm, mm. A vertical wall raises this ball, but
  /// would not raise a true point.
  static constexpr double kPointRadiusMm = 1.0e-5;

  /// Builds the surface.
  /// @param tip_mm diameter of the ball, ≥ 0
  /// @pre the mesh has a facet, and its indices refer to existing points
  ProbeSurface(const surface::Mesh& mesh, double tip_mm);

  /// Returns the height of the ball's lowest point at its first contact, when it descends along Z
  /// at this X and Y. Returns cnc::surface::kNoContact if nothing is under the ball.
  [[nodiscard]] double tip_height(double x_mm, double y_mm, Hint& hint) const {
    return cutter_.tip_height({x_mm, y_mm}, hint);
  }
  /// Returns the height above which the ball touches nothing, mm.
  [[nodiscard]] double top_mm() const { return top_mm_; }

 private:
  surface::DropCutter cutter_;
  double top_mm_;
};

}  // namespace sim

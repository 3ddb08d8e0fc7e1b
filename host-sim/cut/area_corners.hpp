#pragma once

#include <vector>

#include "host-sim/cut/loop_area.hpp"

namespace sim::cut {

/// A point outside of an area at which a shortest path around the area may turn.
struct AreaCorner {
  Place place{0.0, 0.0};
  /// Unit direction in which a path around the area arrives at the corner; the area is on its left.
  Place arriving{1.0, 0.0};
  Place leaving{1.0, 0.0};  ///< Unit direction in which this path leaves the corner.

  /// Returns whether a straight leg between the corner and another point may touch the area without
  /// running into it. The answer is no if the point is outside of both sides of the corner by more
  /// than about ten degrees.
  [[nodiscard]] bool is_touched_from(const Place& other) const;
};

/// Returns the corners of a polygon around an area that keeps `distance_mm` from its skin. Its
/// sides are tangents outside of the area's arcs and of the arcs around its convex corners. Inner
/// corners of the area have no corner in the polygon, because no shortest path turns there.
/// @param distance_mm above 0
[[nodiscard]] std::vector<AreaCorner> corners_around(const LoopArea& area, double distance_mm);

}  // namespace sim::cut

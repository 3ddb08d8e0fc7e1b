#pragma once

#include <vector>

#include "host-sim/cut/loop_area.hpp"

namespace sim::cut {

/// A point outside of an area at which the shortest path around the area may turn.
struct AreaCorner {
  Place place{0.0, 0.0};
  /// Unit direction in which a path around the area arrives at the corner. The area is on the left
  /// of the path.
  Place arriving{1.0, 0.0};
  Place leaving{1.0, 0.0};  ///< Unit direction in which the path leaves the corner.

  /// Returns whether a straight leg between the corner and `other` may pass along the area. Returns
  /// false if `other` is on the outer side of both sides of the polygon that meet at the corner, by
  /// more than about ten degrees. The leg then runs into the corner instead of passing along it.
  [[nodiscard]] bool is_touched_from(const Place& other) const;
};

/// Returns the corners of a polygon around an area. The polygon keeps `distance_mm` from the skin
/// of the area. Its sides are tangents of arcs at this distance around the convex arcs and corners
/// of the area. The polygon has no corners at inner corners of the area, because no shortest path
/// turns there.
/// @param distance_mm above 0
[[nodiscard]] std::vector<AreaCorner> corners_around(const LoopArea& area, double distance_mm);

}  // namespace sim::cut

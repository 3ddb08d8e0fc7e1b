#pragma once

#include <vector>

#include "host-sim/cut/loop_area.hpp"

namespace sim::cut {

/// A place beside an area at which a shortest way round it may turn.
struct AreaCorner {
  Place place{0.0, 0.0};
  Place arriving{1.0, 0.0};  ///< Unit way round the area, which is on its left, to the corner…
  Place leaving{1.0, 0.0};   ///< …and on from it.

  /// Returns whether a straight way between the corner and another place may touch the area instead
  /// of running into it: unless the place is outside of both sides of the corner, by more than
  /// about ten degrees.
  [[nodiscard]] bool is_touched_from(const Place& other) const;
};

/// Returns the corners of a polygon round an area that is no nearer to its skin than so many mm:
/// tangents outside of its arcs and of the rounds about its convex corners. Inner corners have
/// none, as no shortest way turns there.
/// @param distance_mm above 0
[[nodiscard]] std::vector<AreaCorner> corners_around(const LoopArea& area, double distance_mm);

}  // namespace sim::cut

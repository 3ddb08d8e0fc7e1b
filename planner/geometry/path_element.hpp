#pragma once

#include "planner/base/axes.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/geometry/arc_plane.hpp"

namespace cnc {

/// One piece of a tool path: a straight line, or an arc of at most half a turn in a plane. All
/// travel out of that plane is in proportion to the arc length (a helix if the travel is along the
/// normal axis).
///
/// An oblique plane is tilted by the smallest angle with which it contains the chord, whose ends
/// are rounded. Then there is no travel out of the plane.
///
/// The part in the plane is an Arc: two end points and a bulge. End points are exact, so
/// consecutive elements join without a gap even though bulges are rounded.
struct PathElement {
  Position start{};  ///< Start position, machine coordinates.
  Position end{};
  ArcPlane plane{};
  /// Bulge tan(sweep / 4); positive turns counter-clockwise in `plane`, 0 is a line. |bulge| ≤ 1
  /// except for rounding.
  float bulge = 0.0F;
};

}  // namespace cnc

#pragma once

#include "planner/base/axes.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/geometry/arc_plane.hpp"

namespace cnc {

/// One piece of a tool path: a straight line, or an arc of at most half a turn
/// in a plane, with all of its travel off that plane riding along in proportion to
/// the arc length (a helix when that is along the normal axis).
///
/// An oblique plane is tilted as little as lets it hold the chord, whose ends are rounded; nothing
/// rides along.
///
/// The plane part is the project's arc: two end points and a bulge. End points
/// are exact, so pieces join without a gap whatever the bulge was rounded to.
struct PathElement {
  Position start{};  ///< Machine coordinates.
  Position end{};
  ArcPlane plane{};
  /// tan(sweep / 4); positive turns counter-clockwise in `plane`, 0 is a line.
  /// |bulge| ≤ 1 but for rounding.
  float bulge = 0.0F;
};

}  // namespace cnc

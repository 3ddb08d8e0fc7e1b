#pragma once

#include "planner/base/axes.hpp"
#include "planner/base/coordinate.hpp"

namespace cnc {

/// One piece of a tool path: a straight line, or an arc of at most half a turn
/// in a coordinate plane, with every other axis riding along in proportion to
/// the arc length (a helix when that is the normal axis).
///
/// The plane part is the project's arc: two end points and a bulge. End points
/// are exact, so pieces join without a gap whatever the bulge was rounded to.
struct PathElement {
  Position start{};  ///< Machine coordinates.
  Position end{};
  Plane plane = Plane::kXY;
  /// tan(sweep / 4); positive turns counter-clockwise in `plane`, 0 is a line.
  /// |bulge| ≤ 1 but for rounding.
  float bulge = 0.0F;
};

}  // namespace cnc

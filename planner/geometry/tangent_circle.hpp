#pragma once

#include <algorithm>
#include <cmath>

#include "planner/geometry/vector.hpp"

namespace cnc {

/// A circle by a point, the tangent there and the curvature: a line has no case.
struct TangentCircle {
  Vec2 point;
  Vec2 tangent;     ///< Unit vector.
  float curvature;  ///< 1/mm, positive turns left.

  /// Distance from the circle, mm, positive on its right.
  /// With q from the point on the circle, in its frame: the square of the
  /// distance to the centre is (1 + k f) / k², f = k q² − 2 y, and so the
  /// distance to the circle f / (1 + √(1 + k f)).
  [[nodiscard]] float across(const Vec2& place) const {
    const Vec2 q = place - point;
    const float f = curvature * q.squaredNorm() - 2.0F * cross(tangent, q);
    return f / (1.0F + std::sqrt(std::max(0.0F, 1.0F + curvature * f)));
  }

  /// Whether `direction` at `place` is within a quarter turn of the circle's there.
  [[nodiscard]] bool agrees(const Vec2& place, const Vec2& direction) const {
    const Vec2 q = place - point;
    const float along = direction.dot(tangent);
    const float beside = cross(tangent, direction);
    return along * (1.0F - curvature * cross(tangent, q)) + beside * curvature * q.dot(tangent) >
           0.0F;
  }
};

}  // namespace cnc

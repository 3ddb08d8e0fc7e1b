#pragma once

#include <algorithm>
#include <cmath>

#include "planner/geometry/vector.hpp"

namespace cnc {

/// A circle given by a point, the tangent at that point and the curvature. A line needs no separate
/// case.
template <typename Scalar>
struct BasicTangentCircle {
  BasicVec2<Scalar> point;
  BasicVec2<Scalar> tangent;  ///< Unit vector.
  Scalar curvature;           ///< Curvature, 1/mm, positive turns left.

  /// Returns the distance of `place` from the circle, mm, positive on the circle's right. Let k be
  /// the curvature, and q = (x, y) the vector from `point` to `place` in the frame of the tangent.
  /// The square of the distance to the centre is (1 + k f) / k², with f = k q² − 2 y. So the
  /// distance to the circle is f / (1 + √(1 + k f)).
  [[nodiscard]] Scalar across(const BasicVec2<Scalar>& place) const {
    const BasicVec2<Scalar> q = place - point;
    const Scalar f = curvature * q.squaredNorm() - Scalar{2} * cross(tangent, q);
    return f / (Scalar{1} + std::sqrt(std::max(Scalar{0}, Scalar{1} + curvature * f)));
  }

  /// Returns whether `direction` at `place` is within a quarter turn of the circle's direction at
  /// that point.
  [[nodiscard]] bool agrees(const BasicVec2<Scalar>& place,
                            const BasicVec2<Scalar>& direction) const {
    const BasicVec2<Scalar> q = place - point;
    const Scalar along = direction.dot(tangent);
    const Scalar beside = cross(tangent, direction);
    return along * (Scalar{1} - curvature * cross(tangent, q)) +
               beside * curvature * q.dot(tangent) >
           Scalar{0};
  }
};
using TangentCircle = BasicTangentCircle<float>;
/// Circle in double precision, for path makers on the host.
using WideTangentCircle = BasicTangentCircle<double>;

}  // namespace cnc

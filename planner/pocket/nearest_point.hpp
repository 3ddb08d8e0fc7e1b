#pragma once

#include <algorithm>

#include "planner/contour/box_tree.hpp"
#include "planner/contour/curve.hpp"

namespace cnc::pocket {

/// Returns the square of the distance between a point and a box, mm²; 0 inside the box.
template <typename Scalar>
[[nodiscard]] Scalar square_to_box(const contour::FlatBox<Scalar>& box,
                                   const BasicVec2<Scalar>& place) {
  const Scalar x = std::max(Scalar{0}, std::max(box.x0 - place.x(), place.x() - box.x1));
  const Scalar y = std::max(Scalar{0}, std::max(box.y0 - place.y(), place.y() - box.y1));
  return x * x + y * y;
}

/// Returns the point of a line or an arc that is nearest to `place`.
template <typename Scalar>
[[nodiscard]] BasicVec2<Scalar> nearest_point_of(const contour::Curve<Scalar>& curve,
                                                 const BasicVec2<Scalar>& place) {
  if (!curve.faces(place, Scalar{0})) {
    const bool start_is_nearer =
        (place - curve.start).squaredNorm() <= (place - curve.end).squaredNorm();
    return start_is_nearer ? curve.start : curve.end;
  }
  // Half of the gradient of Curve::side. Its length is the distance from the centre divided by the
  // radius.
  const BasicVec2<Scalar> outwards =
      curve.curvature * (place - curve.start) - left_normal(curve.start_tangent);
  const Scalar size = outwards.norm();
  if (size == Scalar{0}) return curve.start;
  return place - curve.side(place) / ((Scalar{1} + size) * size) * outwards;
}

}  // namespace cnc::pocket

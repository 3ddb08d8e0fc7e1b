#pragma once

#include "planner/contour/curve.hpp"

namespace cnc::contour {

/// Returns whether an element vanishes at a signed distance on its right. An arc vanishes if the
/// distance uses up its radius: each moved point would be nearer to another point of the same arc.
template <typename Scalar>
[[nodiscard]] bool is_used_up(const Curve<Scalar>& element, Scalar distance) {
  return Scalar{1} + element.curvature * distance <= Scalar{0};
}

/// Returns the element after it was moved by a signed distance, positive to its right. @pre
/// !is_used_up()
template <typename Scalar>
[[nodiscard]] Curve<Scalar> moved_aside(const Curve<Scalar>& element, Scalar distance) {
  Curve<Scalar> moved = element;
  moved.start -= distance * left_normal(element.start_tangent);
  moved.end -= distance * left_normal(element.end_tangent);
  moved.curvature = element.curvature / (Scalar{1} + element.curvature * distance);
  return moved;
}

/// Returns the arc about the corner between two elements. It leads from the end of the first moved
/// element to the start of the second moved element.
/// @pre the corner opens a gap between the moved elements, and distance is not 0
template <typename Scalar>
[[nodiscard]] Curve<Scalar> round_join(const Curve<Scalar>& before,
                                       const Curve<Scalar>& after,
                                       Scalar distance) {
  const BasicVec2<Scalar> corner = after.start;
  return {corner - distance * left_normal(before.end_tangent),
          corner - distance * left_normal(after.start_tangent),
          before.end_tangent,
          after.start_tangent,
          Scalar{1} / distance};
}

}  // namespace cnc::contour

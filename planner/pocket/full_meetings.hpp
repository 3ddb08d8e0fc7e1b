#pragma once

#include <cmath>

#include "planner/contour/meeting_formulas.hpp"

namespace cnc::pocket {

/// Returns the common points of two complete circles or straight lines, of which the curves `a` and
/// `b` are parts. A point where they touch counts twice. Parallel lines have no common points.
template <typename Scalar>
[[nodiscard]] contour::Meetings<Scalar> full_meetings(const contour::Curve<Scalar>& a,
                                                      const contour::Curve<Scalar>& b) {
  using Vector = BasicVec2<Scalar>;
  contour::Meetings<Scalar> found;
  const bool swap = std::abs(a.curvature) < std::abs(b.curvature);
  const contour::Curve<Scalar>& round = swap ? b : a;  // The curve that bends more.
  const contour::Curve<Scalar>& other = swap ? a : b;
  Vector foot = other.start;
  Vector direction = other.start_tangent;
  if (other.curvature != Scalar{0}) {
    // The line through both common points, as in contour::detail::arcs_meet.
    const Scalar share = other.curvature / round.curvature;
    const Vector normal = other.curvature * (round.start - other.start) -
                          left_normal(other.start_tangent) +
                          share * left_normal(round.start_tangent);
    const Scalar size = normal.norm();
    if (size == Scalar{0}) return found;
    foot = round.start - other.side(round.start) / (Scalar{2} * size * size) * normal;
    direction = left_normal(Vector{normal / size});
  }
  const Vector q = foot - round.start;
  const Scalar half = cross(round.start_tangent, direction) - round.curvature * q.dot(direction);
  const Scalar rest = round.side(foot);
  if (half * half < round.curvature * rest || half == Scalar{0}) return found;
  if (round.curvature == Scalar{0}) {
    found.places[found.count++] = foot + Scalar{0.5} * rest / half * direction;
    return found;
  }
  const auto [first, second] = contour::detail::roots_of(round.curvature, half, rest);
  found.places[found.count++] = foot + first * direction;
  found.places[found.count++] = foot + second * direction;
  return found;
}

}  // namespace cnc::pocket

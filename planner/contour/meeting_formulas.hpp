#pragma once

#include <cmath>
#include <utility>

#include "planner/contour/meeting.hpp"

/// Definitions of the function in meeting.hpp, for the sources that instantiate it.
namespace cnc::contour {
namespace detail {

template <typename Scalar>
void add_if_on_both(Meetings<Scalar>& found,
                    const Curve<Scalar>& a,
                    const Curve<Scalar>& b,
                    const BasicVec2<Scalar>& place,
                    Scalar touch) {
  if (!a.faces(place, touch) || !b.faces(place, touch)) return;
  // faces() also accepts points near the far side of the circle, beyond its centre, where the curve
  // does not run.
  if (!(a.from_circle(place) <= touch) || !(b.from_circle(place) <= touch)) return;
  found.places[found.count++] = place;
}

template <typename Scalar>
Meetings<Scalar> lines_meet(const Curve<Scalar>& a, const Curve<Scalar>& b, Scalar touch) {
  Meetings<Scalar> found;
  const Scalar sine = cross(a.start_tangent, b.start_tangent);
  const BasicVec2<Scalar> between = b.start - a.start;
  const Scalar along = cross(between, b.start_tangent) / sine;
  if (!(std::abs(along) <
        std::abs(a.end.x() - a.start.x()) + std::abs(a.end.y() - a.start.y()) + touch)) {
    return found;
  }
  add_if_on_both(found, a, b, BasicVec2<Scalar>{a.start + along * a.start_tangent}, touch);
  return found;
}

/// Roots τ of κ τ² − 2 half τ + rest = 0. The intersections are the points origin + τ direction.
template <typename Scalar>
struct Roots {
  Scalar first;
  Scalar second;
};

/// Returns both roots without cancellation. If the line misses the circle, the line is treated as a
/// tangent.
template <typename Scalar>
Roots<Scalar> roots_of(Scalar curvature, Scalar half, Scalar rest) {
  const Scalar root = std::sqrt(std::max(Scalar{0}, half * half - curvature * rest));
  const Scalar large = half < Scalar{0} ? half - root : half + root;
  if (large == Scalar{0}) return {Scalar{0}, Scalar{0}};
  return {rest / large, large / curvature};
}

/// Returns the points where the straight line through `foot` along `direction` intersects the
/// circle of `round`, if these points are on both curves.
template <typename Scalar>
Meetings<Scalar> line_meets(const Curve<Scalar>& round,
                            const Curve<Scalar>& other,
                            const BasicVec2<Scalar>& foot,
                            const BasicVec2<Scalar>& direction,
                            Scalar touch) {
  const BasicVec2<Scalar> q = foot - round.start;
  const Scalar half = cross(round.start_tangent, direction) - round.curvature * q.dot(direction);
  const Scalar rest = round.side(foot);
  const auto [first, second] = roots_of(round.curvature, half, rest);
  Meetings<Scalar> found;
  add_if_on_both(found, round, other, BasicVec2<Scalar>{foot + first * direction}, touch);
  if (first == second) return found;
  add_if_on_both(found, round, other, BasicVec2<Scalar>{foot + second * direction}, touch);
  return found;
}

template <typename Scalar>
Meetings<Scalar> line_and_arc_meet(const Curve<Scalar>& line,
                                   const Curve<Scalar>& arc,
                                   Scalar touch) {
  // Coordinates are relative to the foot of the arc's start on the line, so that no large numbers
  // cancel.
  const Scalar along = line.start_tangent.dot(arc.start - line.start);
  const BasicVec2<Scalar> foot = line.start + along * line.start_tangent;
  return line_meets(arc, line, foot, line.start_tangent, touch);
}

/// Intersects the radical line of both circles with the smaller circle.
template <typename Scalar>
Meetings<Scalar> arcs_meet(const Curve<Scalar>& small, const Curve<Scalar>& large, Scalar touch) {
  const Scalar share = large.curvature / small.curvature;
  const BasicVec2<Scalar> between = small.start - large.start;
  const BasicVec2<Scalar> normal = large.curvature * between - left_normal(large.start_tangent) +
                                   share * left_normal(small.start_tangent);
  const Scalar size = normal.norm();
  // The centres are practically equal: the circles coincide, or they do not intersect.
  if (!(size > touch * std::abs(large.curvature))) return {};
  const BasicVec2<Scalar> across = normal / size;
  const Scalar height = -large.side(small.start) / (Scalar{2} * size);
  const BasicVec2<Scalar> foot = small.start + height * across;
  return line_meets(small, large, foot, left_normal(across), touch);
}

}  // namespace detail

template <typename Scalar>
Meetings<Scalar> meetings_of(const Curve<Scalar>& a, const Curve<Scalar>& b, Scalar touch) {
  const bool a_straight = a.curvature == Scalar{0};
  const bool b_straight = b.curvature == Scalar{0};
  if (a_straight && b_straight) return detail::lines_meet(a, b, touch);
  if (a_straight) return detail::line_and_arc_meet(a, b, touch);
  if (b_straight) return detail::line_and_arc_meet(b, a, touch);
  if (std::abs(a.curvature) >= std::abs(b.curvature)) return detail::arcs_meet(a, b, touch);
  return detail::arcs_meet(b, a, touch);
}

}  // namespace cnc::contour

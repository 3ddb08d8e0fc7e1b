#include "planner/compensation/clearance.hpp"

#include <cmath>

#include "planner/contour/meeting.hpp"

namespace cnc::compensation {
namespace {

/// Returns an upper bound of the length of a curve: half a turn is as long as π / 2 chords.
float length_bound(const Curve& curve) { return 1.5708F * (curve.end - curve.start).norm(); }

bool ends_come_nearer(const Curve& a, const Curve& b, float limit) {
  return distance(b, a.start) < limit || distance(b, a.end) < limit ||
         distance(a, b.start) < limit || distance(a, b.end) < limit;
}

/// Returns the common direction of the tangents at the points where the circles of the two curves
/// are nearest to each other, or farthest. The result is zero if the circles are equally near
/// everywhere.
Vec2 common_direction(const Curve& a, const Curve& b) {
  if (a.curvature == 0.0F) return a.start_tangent;
  if (b.curvature == 0.0F) return b.start_tangent;
  // Vector from centre to centre, multiplied by both curvatures. In this form no far-away centre is
  // computed.
  const Vec2 across = a.curvature * b.curvature * (a.start - b.start) +
                      b.curvature * left_normal(a.start_tangent) -
                      a.curvature * left_normal(b.start_tangent);
  const float size = across.norm();
  if (!(size > kTouch * std::abs(a.curvature * b.curvature))) return Vec2::Zero();
  return left_normal(across) / size;
}

/// Returns the point where the tangent of an arc has the given direction. Up to a quarter turn from
/// the start, the point is computed along a chord, whose error is only along the arc. Beyond that
/// it is computed from the centre.
Vec2 place_with_tangent(const Curve& arc, const Vec2& direction) {
  const Vec2 turn = direction - arc.start_tangent;
  if (direction.dot(arc.start_tangent) < 0.0F) {
    return arc.start - left_normal(turn) / arc.curvature;
  }
  const float chord = turn.norm() / arc.curvature;
  const Vec2 along = (direction + arc.start_tangent).normalized();
  return arc.start + (cross(arc.start_tangent, direction) < 0.0F ? -chord : chord) * along;
}

bool side_comes_nearer(const Curve& arc, const Vec2& direction, const Curve& other, float limit) {
  const Vec2 place = place_with_tangent(arc, direction);
  return arc.faces(place, 0.0F) && distance(other, place) < limit;
}

bool sides_come_nearer(const Curve& arc, const Vec2& direction, const Curve& other, float limit) {
  return arc.curvature != 0.0F && (side_comes_nearer(arc, direction, other, limit) ||
                                   side_comes_nearer(arc, -direction, other, limit));
}

}  // namespace

Curve straight(const Vec2& start, const Vec2& end) {
  const Vec2 way = end - start;
  const float length = way.norm();
  const Vec2 along = length > 0.0F ? Vec2{way / length} : Vec2{1.0F, 0.0F};
  return {start, end, along, along, 0.0F};
}

float distance(const Curve& curve, const Vec2& place) {
  const float own = curve.distance(place);
  if (!(own * std::abs(curve.curvature) > 0.5F) || !curve.faces(place, 0.0F)) return own;
  const Vec2 centre = curve.start + left_normal(curve.start_tangent) / curve.curvature;
  return std::abs((place - centre).norm() - 1.0F / std::abs(curve.curvature));
}

bool come_nearer(const Curve& a, const Curve& b, float limit) {
  const float apart = (a.start - b.start).norm() - length_bound(a) - length_bound(b);
  if (apart > limit) return false;
  if (ends_come_nearer(a, b, limit)) return true;
  if (contour::meetings_of(a, b, kTouch).count > 0) return true;
  if (a.curvature == 0.0F && b.curvature == 0.0F) return false;
  const Vec2 direction = common_direction(a, b);
  if (direction.isZero(0.0F)) return false;
  return sides_come_nearer(a, direction, b, limit) || sides_come_nearer(b, direction, a, limit);
}

}  // namespace cnc::compensation

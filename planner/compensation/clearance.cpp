#include "planner/compensation/clearance.hpp"

#include <cmath>

#include "planner/contour/meeting.hpp"

namespace cnc::compensation {
namespace {

/// An upper bound: half a turn is as long as π / 2 chords.
float length_bound(const Curve& curve) { return 1.5708F * (curve.end - curve.start).norm(); }

bool ends_come_nearer(const Curve& a, const Curve& b, float limit) {
  return b.distance(a.start) < limit || b.distance(a.end) < limit || a.distance(b.start) < limit ||
         a.distance(b.end) < limit;
}

/// Direction of both tangents where the circles are nearest to each other, or farthest; zero
/// where that is everywhere.
Vec2 common_direction(const Curve& a, const Curve& b) {
  if (a.curvature == 0.0F) return a.start_tangent;
  if (b.curvature == 0.0F) return b.start_tangent;
  // From centre to centre, times both curvatures: no far-away centre.
  const Vec2 across = a.curvature * b.curvature * (a.start - b.start) +
                      b.curvature * left_normal(a.start_tangent) -
                      a.curvature * left_normal(b.start_tangent);
  const float size = across.norm();
  if (!(size > kTouch * std::abs(a.curvature * b.curvature))) return Vec2::Zero();
  return left_normal(across) / size;
}

/// Whether the place of an arc at which its tangent has the direction is nearer.
bool side_comes_nearer(const Curve& arc, const Vec2& direction, const Curve& other, float limit) {
  const Vec2 place =
      arc.start - left_normal(Vec2{direction - arc.start_tangent}) / arc.curvature;
  return arc.faces(place, 0.0F) && other.distance(place) < limit;
}

bool sides_come_nearer(const Curve& arc, const Vec2& direction, const Curve& other, float limit) {
  return arc.curvature != 0.0F && (side_comes_nearer(arc, direction, other, limit) ||
                                   side_comes_nearer(arc, -direction, other, limit));
}

}  // namespace

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

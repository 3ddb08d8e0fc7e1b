#include "planner/path/blend.hpp"

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc.hpp"
#include "planner/geometry/biarc.hpp"
#include "planner/path/space_biarc.hpp"

namespace cnc::path {
namespace {

float bulge_from(float half_sweep) { return tangent_of(0.5F * half_sweep); }

/// Returns an arc between two positions that has a given direction at its start or, with `at_end`,
/// at its end.
PathElement arc_between(const Position& from,
                        const Position& to,
                        const AxisVector& direction,
                        bool at_end) {
  PathElement arc{.start = from, .end = to};
  const AxisVector way = travel_between(from, to);
  const float length = norm(way);
  if (length <= 0.0F) return arc;
  const AxisVector chord = scaled(1.0F / length, way);
  const auto plane = at_end ? plane_of(chord, direction) : plane_of(direction, chord);
  if (!plane) return arc;
  arc.plane = *plane;
  const Vec2 across = plane->seen(way);
  const Vec2 onwards = plane->seen(direction);
  arc.bulge = at_end ? bulge_between(across, onwards) : bulge_between(onwards, across);
  return arc;
}

}  // namespace

/// The bulges are computed from the joint after its rounding to nanometres, as in ArcFit. So the
/// blend has exactly the directions of the legs at its ends, and the kink that results from
/// rounding is at the joint.
Blend make_blend(
    const Corner& corner, const Position& from, const Position& to, float trim_mm, bool in_halves) {
  Blend blend;
  auto& [first, second] = blend.parts;
  if (corner.is_straight() && !in_halves) {
    const auto plane = corner.plane();
    if (!plane) return blend;
    first = {.start = from, .end = to, .plane = *plane};
    first.bulge = bulge_from(0.5F * corner.turn);
    blend.count = 1;
    return blend;
  }
  const AxisVector start = corner.before.direction(-trim_mm);
  const AxisVector end = corner.after.direction(trim_mm);
  const auto joint = space_joint(start, travel_between(from, to), end);
  if (!joint) return blend;
  const Position between = moved_by(from, *joint);
  first = arc_between(from, between, start, false);
  second = arc_between(between, to, end, true);
  blend.count = 2;
  return blend;
}

void become_part(PathElement& element, const Position& from, const Position& to, float share) {
  const Vec2 chord = element.plane.seen(element.start, element.end);
  element.start = from;
  element.end = to;
  if (element.bulge == 0.0F || share >= 1.0F) return;
  const auto arc = Arc::make(Vec2{0.0F, 0.0F}, chord, element.bulge);
  if (arc.ok()) element.bulge = bulge_from(arc.value().half_sweep() * share);
}

}  // namespace cnc::path

#include "planner/path/blend.hpp"

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc.hpp"

namespace cnc::path {
namespace {

float bulge_from(float half_sweep) {
  const SinCos half = sin_cos(0.5F * half_sweep);
  return half.sine / half.cosine;
}

Vec2 in_plane(const Position& from, const Position& to, Plane plane) {
  const PlaneAxes axes = axes_of(plane);
  return {(to[axes.first] - from[axes.first]).mm(), (to[axes.second] - from[axes.second]).mm()};
}

float length_between(const Vec2& chord, float bulge) {
  const auto arc = Arc::make(Vec2{0.0F, 0.0F}, chord, bulge);
  return arc.ok() ? arc.value().length().in_mm_and_s() : 0.0F;
}

/// The joint in all axes: those off the plane in proportion to the length.
Position place_joint(const PathElement& whole, const BiarcEnds& ends, const Biarc& biarc) {
  const PlaneAxes axes = axes_of(whole.plane);
  const float first = length_between(biarc.joint, biarc.first_bulge);
  const float second = length_between(ends.end - biarc.joint, biarc.second_bulge);
  const float share = first + second > 0.0F ? first / (first + second) : 0.5F;
  Position joint = whole.start;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    joint[axis] += from_mm((whole.end[axis] - whole.start[axis]).mm() * share);
  }
  joint[axes.first] = whole.start[axes.first] + from_mm(biarc.joint.x());
  joint[axes.second] = whole.start[axes.second] + from_mm(biarc.joint.y());
  return joint;
}

}  // namespace

/// Bulges are taken from the rounded joint, as ArcFit does: the tangents at the
/// ends are met, and what rounding leaves of a corner is at the joint.
Blend make_blend(
    const Corner& corner, const Position& from, const Position& to, float trim_mm, bool in_halves) {
  Blend blend;
  auto& [first, second] = blend.parts;
  first = {.start = from, .end = to, .plane = corner.plane};
  if (corner.is_straight() && !in_halves) {
    first.bulge = bulge_from(0.5F * corner.turn);
    blend.count = 1;
    return blend;
  }
  BiarcEnds ends = ends_of(corner, trim_mm);
  ends.start = {0.0F, 0.0F};
  ends.end = in_plane(from, to, corner.plane);
  const auto biarc = make_biarc(ends, 0.5F);
  if (!biarc.ok()) return blend;
  second = first;
  first.end = second.start = place_joint(second, ends, biarc.value());
  first.bulge = bulge_between(ends.start_tangent, in_plane(from, first.end, corner.plane));
  second.bulge = bulge_between(in_plane(second.start, to, corner.plane), ends.end_tangent);
  blend.count = 2;
  return blend;
}

PathElement part_of(const PathElement& whole,
                    const Position& from,
                    const Position& to,
                    float share) {
  PathElement part = whole;
  part.start = from;
  part.end = to;
  if (whole.bulge == 0.0F || share >= 1.0F) return part;
  const auto arc =
      Arc::make(Vec2{0.0F, 0.0F}, in_plane(whole.start, whole.end, whole.plane), whole.bulge);
  if (arc.ok()) part.bulge = bulge_from(arc.value().half_sweep() * share);
  return part;
}

}  // namespace cnc::path

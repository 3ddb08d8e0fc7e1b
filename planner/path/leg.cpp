#include "planner/path/leg.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc.hpp"

namespace cnc::path {
namespace {

/// Returns the tangent of a leg, turned to the left by an angle in radians.
AxisVector turned(const Leg& leg, float angle) {
  const SinCos by = sin_cos(angle);
  return sum_of(scaled(by.cosine, leg.tangent), by.sine, leg.normal);
}

AxisVector straight_direction(const AxisVector& way) {
  AxisVector direction = way;
  const float length = norm(way);
  if (length <= 0.0F) return direction;
  for (float& share : direction) share /= length;
  return direction;
}

std::optional<Leg> leg_of(const PathElement& element, bool at_end) {
  const AxisVector way = travel_between(element.start, element.end);
  if (element.bulge == 0.0F) {
    const float length = norm(way);
    if (length <= 0.0F) return std::nullopt;
    return Leg{.tangent = straight_direction(way), .length = length};
  }
  const ArcPlane& plane = element.plane;
  const auto arc = Arc::make(Vec2{0.0F, 0.0F}, plane.seen(way), element.bulge);
  if (!arc.ok()) return std::nullopt;
  const Vec2 tangent = at_end ? arc.value().end_tangent() : arc.value().start_tangent();
  Leg leg{.tangent = plane.vector(tangent),
          .normal = plane.vector(left_normal(tangent)),
          .off_plane = plane.off(way),
          .curvature = arc.value().curvature(),
          .length = arc.value().length().in_mm_and_s()};
  for (float& share : leg.off_plane) share /= leg.length;
  leg.plane_share = 1.0F / std::sqrt(1.0F + dot(leg.off_plane, leg.off_plane));
  leg.length /= leg.plane_share;
  return leg;
}

AxisVector direction_of(const PathElement& element, bool at_end) {
  const auto leg = leg_of(element, at_end);
  return leg ? leg->direction(0.0F)
             : straight_direction(travel_between(element.start, element.end));
}

}  // namespace

AxisVector Leg::place(float way) const {
  if (curvature == 0.0F) return scaled(way, tangent);
  // Chord of this part of the circle: its length is the arc length times sin h / h, with h =
  // `half`. Its direction is the tangent turned by h.
  const float in_plane = way * plane_share;
  const float half = 0.5F * curvature * in_plane;
  const bool flat = std::abs(half) < 1.0e-3F;
  const float share = flat ? 1.0F - square(half) * (1.0F / 6.0F) : sin_cos(half).sine / half;
  return sum_of(scaled(in_plane * share, turned(*this, half)), in_plane, off_plane);
}

AxisVector Leg::direction(float way) const {
  if (curvature == 0.0F) return tangent;
  const AxisVector in_plane = turned(*this, curvature * way * plane_share);
  return scaled(plane_share, sum_of(in_plane, 1.0F, off_plane));
}

/// The angle between tangent and chord is half of the angle by which the circle turns along the
/// chord.
Leg leg_through(const AxisVector& tangent, const AxisVector& chord) {
  const float length = norm(chord);
  const auto frame = plane_through(tangent, scaled(1.0F / length, chord));
  if (!frame) return {.tangent = tangent, .length = length};
  const float along = std::abs(dot(chord, frame->first));
  const float aside = dot(chord, frame->second);
  return {.tangent = frame->first,
          .normal = frame->second,
          .curvature = 2.0F * aside / square(length),
          .length = length * (atan2_f(aside, along) * length / aside)};
}

std::optional<Leg> leg_before(const PathElement& element) { return leg_of(element, true); }
std::optional<Leg> leg_after(const PathElement& element) { return leg_of(element, false); }

float length_of(const PathElement& element) {
  const auto leg = leg_of(element, false);
  return leg ? leg->length : 0.0F;
}

AxisVector start_direction(const PathElement& element) { return direction_of(element, false); }
AxisVector end_direction(const PathElement& element) { return direction_of(element, true); }

}  // namespace cnc::path

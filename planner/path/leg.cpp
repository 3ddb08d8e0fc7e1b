#include "planner/path/leg.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc.hpp"

namespace cnc::path {
namespace {

Vec2 rotated(const Vec2& vector, float angle) {
  const SinCos by = sin_cos(angle);
  return by.cosine * vector + by.sine * left_normal(vector);
}

/// An element in a plane: its arc, and how the other axes go along.
struct Flat {
  float length = 0.0F;
  float curvature = 0.0F;
  Vec2 start_tangent{1.0F, 0.0F};
  Vec2 end_tangent{1.0F, 0.0F};
  AxisArray<float> slope{};
};

std::optional<Flat> flat_in(const PathElement& element, Plane plane) {
  if (element.bulge != 0.0F && element.plane != plane) return std::nullopt;
  const PlaneAxes axes = axes_of(plane);
  AxisArray<float> travel{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    travel[axis] = (element.end[axis] - element.start[axis]).mm();
  }
  const Vec2 chord{travel[axes.first], travel[axes.second]};
  const auto arc = Arc::make(Vec2{0.0F, 0.0F}, chord, element.bulge);
  if (!arc.ok()) return std::nullopt;
  Flat flat{.length = arc.value().length().in_mm_and_s(),
            .curvature = arc.value().curvature(),
            .start_tangent = arc.value().start_tangent(),
            .end_tangent = arc.value().end_tangent()};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const bool off_plane = axis != axes.first && axis != axes.second;
    if (off_plane) flat.slope[axis] = travel[axis] / flat.length;
  }
  return flat;
}

AxisArray<float> straight_direction(const PathElement& element) {
  AxisArray<float> travel{};
  float sum = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    travel[axis] = (element.end[axis] - element.start[axis]).mm();
    sum += square(travel[axis]);
  }
  if (sum <= 0.0F) return travel;
  const float scale = 1.0F / std::sqrt(sum);
  for (float& share : travel) share *= scale;
  return travel;
}

AxisArray<float> direction_of(const PathElement& element, bool at_end) {
  if (element.bulge == 0.0F) return straight_direction(element);
  const auto flat = flat_in(element, element.plane);
  if (!flat) return straight_direction(element);
  float sum = 1.0F;
  for (const float share : flat->slope) sum += square(share);
  const float scale = 1.0F / std::sqrt(sum);
  const Vec2& tangent = at_end ? flat->end_tangent : flat->start_tangent;
  AxisArray<float> direction = flat->slope;
  direction[axes_of(element.plane).first] = tangent.x();
  direction[axes_of(element.plane).second] = tangent.y();
  for (float& share : direction) share *= scale;
  return direction;
}

}  // namespace

Vec2 Leg::place(float way) const {
  // The chord of that part of the circle: sin h / h times as long, turned by h.
  const float half = 0.5F * curvature * way;
  const bool flat = std::abs(half) < 1.0e-3F;
  const float share = flat ? 1.0F - square(half) * (1.0F / 6.0F) : sin_cos(half).sine / half;
  return way * share * rotated(tangent, half);
}

Vec2 Leg::tangent_at(float way) const { return rotated(tangent, curvature * way); }

std::optional<Leg> leg_before(const PathElement& element, Plane plane) {
  const auto flat = flat_in(element, plane);
  if (!flat) return std::nullopt;
  return Leg{flat->end_tangent, flat->curvature, flat->length, flat->slope};
}

std::optional<Leg> leg_after(const PathElement& element, Plane plane) {
  const auto flat = flat_in(element, plane);
  if (!flat) return std::nullopt;
  return Leg{flat->start_tangent, flat->curvature, flat->length, flat->slope};
}

float length_in(const PathElement& element, Plane plane) {
  const auto flat = flat_in(element, plane);
  return flat ? flat->length : 0.0F;
}

Position place_on(const Leg& leg, Plane plane, const Position& corner, float way) {
  const PlaneAxes axes = axes_of(plane);
  const Vec2 offset = leg.place(way);
  Position place = corner;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis)
    place[axis] += from_mm(leg.slope[axis] * way);
  place[axes.first] = corner[axes.first] + from_mm(offset.x());
  place[axes.second] = corner[axes.second] + from_mm(offset.y());
  return place;
}

AxisArray<float> start_direction(const PathElement& element) {
  return direction_of(element, false);
}
AxisArray<float> end_direction(const PathElement& element) { return direction_of(element, true); }

}  // namespace cnc::path

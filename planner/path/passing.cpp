#include "planner/path/passing.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/path/leg.hpp"

namespace cnc::path {
namespace {

using Offset = AxisArray<float>;

Offset offset_of(const Position& from, const Position& to) {
  Offset offset{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) offset[axis] = (to[axis] - from[axis]).mm();
  return offset;
}

float dot(const Offset& a, const Offset& b) {
  float sum = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) sum += a[axis] * b[axis];
  return sum;
}

Passing on_line(const PathElement& line, const Position& place) {
  const Offset way = offset_of(line.start, line.end);
  const float square = dot(way, way);
  if (square <= 0.0F) return {.place = line.end, .share = 1.0F};
  const float share = dot(way, offset_of(line.start, place)) / square;
  if (share >= 1.0F) return {.place = line.end, .share = 1.0F};
  Passing passing{.place = line.start, .share = std::max(0.0F, share)};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    passing.place[axis] += from_mm(way[axis] * passing.share);
  }
  return passing;
}

/// A chord of a circle leaves it at half the angle that it spans. From whichever end is farther
/// away, where the chord's direction is known best.
float way_along(const Leg& from_start, const Leg& to_end, const Vec2& start, const Vec2& end) {
  const bool by_start = start.squaredNorm() >= end.squaredNorm();
  const Vec2& tangent = by_start ? from_start.tangent : to_end.tangent;
  const float half = by_start ? atan2_f(cross(tangent, start), tangent.dot(start))
                              : atan2_f(cross(end, tangent), tangent.dot(end));
  const float way = 2.0F * half / from_start.curvature;
  return by_start ? way : from_start.length - way;
}

Passing on_arc(const PathElement& arc, const Leg& leg, const Position& place) {
  const PlaneAxes axes = axes_of(arc.plane);
  const auto in_plane = [&](const Offset& offset) {
    return Vec2{offset[axes.first], offset[axes.second]};
  };
  const auto at_end = leg_before(arc, arc.plane);
  const float way = at_end ? way_along(leg,
                                       *at_end,
                                       in_plane(offset_of(arc.start, place)),
                                       in_plane(offset_of(place, arc.end)))
                           : leg.length;
  if (way >= leg.length) return {.place = arc.end, .share = 1.0F};
  if (way <= 0.0F) return {.place = arc.start};
  return {.place = place_on(leg, arc.plane, arc.start, way), .share = way / leg.length};
}

}  // namespace

Passing passing_of(const PathElement& element, const Position& place) {
  const auto leg = element.bulge != 0.0F ? leg_after(element, element.plane) : std::optional<Leg>{};
  Passing passing = leg ? on_arc(element, *leg, place) : on_line(element, place);
  const Offset beside = offset_of(passing.place, place);
  passing.distance_mm = std::sqrt(dot(beside, beside));
  return passing;
}

}  // namespace cnc::path

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

/// How far along the arc a place is from an end of it, by the chord to there. Negative before it.
float way_from(const Vec2& tangent, float curvature, const Vec2& chord) {
  constexpr float kFlat = 1.0e-3F;
  const float length = chord.norm();
  if (tangent.dot(chord) <= 0.0F) return -length;
  const float sine = std::min(1.0F, 0.5F * length * std::abs(curvature));
  if (sine < kFlat) return length * (1.0F + square(sine) * (1.0F / 6.0F));
  return 2.0F * atan2_f(sine, std::sqrt(1.0F - square(sine))) / std::abs(curvature);
}

/// From the end that is nearer: there is at most a quarter of a turn to it.
float way_along(const Leg& from_start, const Leg& to_end, const Vec2& start, const Vec2& end) {
  const float curvature = from_start.curvature;
  if (start.squaredNorm() <= end.squaredNorm()) {
    return way_from(from_start.tangent, curvature, start);
  }
  return from_start.length - way_from(to_end.tangent, curvature, end);
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

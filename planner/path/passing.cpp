#include "planner/path/passing.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/path/leg.hpp"

namespace cnc::path {
namespace {

Passing on_line(const PathElement& line, const Position& place) {
  const AxisVector way = travel_between(line.start, line.end);
  const float square = dot(way, way);
  if (square <= 0.0F) return {.place = line.end, .share = 1.0F};
  const float share = dot(way, travel_between(line.start, place)) / square;
  if (share >= 1.0F) return {.place = line.end, .share = 1.0F};
  const float passed = std::max(0.0F, share);
  return {.place = moved_by(line.start, scaled(passed, way)), .share = passed};
}

/// Returns the distance along the arc between an end of the arc and a position, in mm in the arc's
/// plane; negative if the position is beyond the end.
/// @param chord chord between that end and the position
/// @param ahead component of the chord along the tangent; negative beyond the end
float way_from(const Leg& leg, const Vec2& chord, float ahead) {
  constexpr float kFlat = 1.0e-3F;
  const float length = chord.norm();
  if (ahead <= 0.0F) return -length;
  const float curvature = std::abs(leg.curvature);
  const float sine = std::min(1.0F, 0.5F * length * curvature);
  if (sine < kFlat) return length * (1.0F + square(sine) * (1.0F / 6.0F));
  return 2.0F * atan2_f(sine, std::sqrt(1.0F - square(sine))) / curvature;
}

/// Measures from the end that is nearer to `place`. This end is at most a quarter turn away.
Passing on_arc(const PathElement& arc, const Leg& from_start, const Position& place) {
  const auto to_end = leg_before(arc);
  if (!to_end) return {.place = arc.end, .share = 1.0F};
  const AxisVector behind = travel_between(arc.start, place);
  const AxisVector ahead = travel_between(place, arc.end);
  const Vec2 from = arc.plane.seen(behind);
  const Vec2 to = arc.plane.seen(ahead);
  const float length = from_start.length * from_start.plane_share;
  const float way = from.squaredNorm() <= to.squaredNorm()
                        ? way_from(from_start, from, dot(from_start.tangent, behind))
                        : length - way_from(*to_end, to, dot(to_end->tangent, ahead));
  if (way >= length) return {.place = arc.end, .share = 1.0F};
  if (way <= 0.0F) return {.place = arc.start};
  const float share = way / length;
  return {.place = moved_by(arc.start, from_start.place(share * from_start.length)),
          .share = share};
}

}  // namespace

Passing passing_of(const PathElement& element, const Position& place) {
  const auto leg = element.bulge != 0.0F ? leg_after(element) : std::optional<Leg>{};
  Passing passing = leg ? on_arc(element, *leg, place) : on_line(element, place);
  passing.distance_mm = norm(travel_between(passing.place, place));
  return passing;
}

}  // namespace cnc::path

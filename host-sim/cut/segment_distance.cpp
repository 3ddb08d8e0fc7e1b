#include "host-sim/cut/segment_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sim::cut {
namespace {

/// Returns whether a point on the circle of an arc is on the arc. For any sweep, the arc is on that
/// side of its chord to which it bulges.
bool is_on_arc(const Stroke& arc, const Place& place) {
  const double side = drawing::cross(arc.to - arc.from, place - arc.from);
  return arc.bulge > 0.0 ? side <= 0.0 : side >= 0.0;
}

Place nearest_on_line(const Place& from, const Place& to, const Place& place) {
  const Place way = to - from;
  const double square = way.squaredNorm();
  if (square <= 0.0) return from;
  return from + std::clamp(drawing::dot(place - from, way) / square, 0.0, 1.0) * way;
}

/// Points where the line through two points crosses a circle, as shares of the distance between the
/// two points, the smaller share first. `meets` is false if the line misses the circle.
struct CircleMeetings {
  std::array<double, 2> shares{};
  bool meets = false;
};

CircleMeetings meet_circle(const Place& from, const Place& to, const Place& centre, double radius) {
  const Place way = to - from;
  const double square = way.squaredNorm();
  if (square <= 0.0) return {};
  const double foot = drawing::dot(centre - from, way) / square;
  const double aside = drawing::cross(way, centre - from) / std::sqrt(square);
  const double rest = (radius - aside) * (radius + aside);
  if (rest < 0.0) return {};
  const double half = std::sqrt(rest / square);
  return {{foot - half, foot + half}, true};
}

double distance_of_lines(const Place& a, const Place& b, const Stroke& line) {
  const Place way = b - a;
  const Place chord = line.to - line.from;
  const double from_side = drawing::cross(way, line.from - a);
  const double to_side = drawing::cross(way, line.to - a);
  const double a_side = drawing::cross(chord, a - line.from);
  const double b_side = drawing::cross(chord, b - line.from);
  const bool crosses = ((from_side > 0.0) != (to_side > 0.0)) && ((a_side > 0.0) != (b_side > 0.0));
  if (crosses) return 0.0;
  return std::min({drawing::distance(a, nearest_on_line(line.from, line.to, a)),
                   drawing::distance(b, nearest_on_line(line.from, line.to, b)),
                   drawing::distance(line.from, nearest_on_line(a, b, line.from)),
                   drawing::distance(line.to, nearest_on_line(a, b, line.to))});
}

double distance_to_arc(const Place& a, const Place& b, const Stroke& arc) {
  const Place centre = arc_centre(arc);
  const double radius = drawing::distance(centre, arc.from);
  const CircleMeetings met = meet_circle(a, b, centre, radius);
  for (const double share : met.shares) {
    if (met.meets && share >= 0.0 && share <= 1.0 && is_on_arc(arc, a + share * (b - a))) {
      return 0.0;
    }
  }
  const Place foot = nearest_on_line(a, b, centre);
  return std::min({drawing::distance(a, nearest_on(arc, a)),
                   drawing::distance(b, nearest_on(arc, b)),
                   drawing::distance(foot, nearest_on(arc, foot)),
                   drawing::distance(arc.from, nearest_on_line(a, b, arc.from)),
                   drawing::distance(arc.to, nearest_on_line(a, b, arc.to))});
}

}  // namespace

Place arc_centre(const Stroke& arc) {
  const double across = (1.0 - arc.bulge * arc.bulge) / (4.0 * arc.bulge);
  const Place chord = arc.to - arc.from;
  return 0.5 * (arc.from + arc.to) - across * right_of(chord);
}

Place nearest_on(const Stroke& stroke, const Place& place) {
  if (stroke.bulge == 0.0) return nearest_on_line(stroke.from, stroke.to, place);
  const Place centre = arc_centre(stroke);
  const double radius = drawing::distance(centre, stroke.from);
  const double away = drawing::distance(centre, place);
  if (away > 0.0) {
    Place on_circle = centre + radius / away * (place - centre);
    if (is_on_arc(stroke, on_circle)) return on_circle;
  }
  const bool from_is_nearer =
      drawing::distance(stroke.from, place) <= drawing::distance(stroke.to, place);
  return from_is_nearer ? stroke.from : stroke.to;
}

double nearest_share(const Stroke& stroke, const Place& place) {
  const Place way = nearest_on(stroke, place) - stroke.from;
  // For an arc this flat, the share along the arc equals the share along its chord within 1e-8.
  // Angles computed from such an arc would contain only rounding.
  constexpr double kFlatBulge = 1.0e-4;
  if (std::abs(stroke.bulge) < kFlatBulge) {
    const double square = (stroke.to - stroke.from).squaredNorm();
    return square > 0.0 ? std::clamp(std::sqrt(way.squaredNorm() / square), 0.0, 1.0) : 0.0;
  }
  // If the point is this near to the start, its direction from the start contains only rounding.
  constexpr double kNoShare = 1.0e-9;
  if (way.norm() < kNoShare * length_of(stroke)) return 0.0;
  // The angle between the tangent at the start and a chord from there is half of the angle of the
  // arc over this chord.
  const Place tangent = tangent_at(stroke, 0.0);
  const double half = std::atan2(drawing::cross(tangent, way), drawing::dot(tangent, way));
  return std::clamp(half / (2.0 * std::atan(stroke.bulge)), 0.0, 1.0);
}

double segment_distance(const Place& from, const Place& to, const Stroke& stroke) {
  return stroke.bulge == 0.0 ? distance_of_lines(from, to, stroke)
                             : distance_to_arc(from, to, stroke);
}

void add_meetings(const Place& from,
                  const Place& to,
                  const Stroke& stroke,
                  std::vector<double>& shares) {
  const Place way = to - from;
  if (stroke.bulge == 0.0) {
    const Place chord = stroke.to - stroke.from;
    const double turn = drawing::cross(way, chord);
    if (turn == 0.0) return;
    const double share = drawing::cross(stroke.from - from, chord) / turn;
    const double along = drawing::cross(stroke.from - from, way) / turn;
    if (share >= 0.0 && share <= 1.0 && along >= 0.0 && along <= 1.0) shares.push_back(share);
    return;
  }
  const Place centre = arc_centre(stroke);
  const CircleMeetings met = meet_circle(from, to, centre, drawing::distance(centre, stroke.from));
  for (const double share : met.shares) {
    if (met.meets && share >= 0.0 && share <= 1.0 && is_on_arc(stroke, from + share * way)) {
      shares.push_back(share);
    }
  }
}

}  // namespace sim::cut

#include "host-sim/cut/stroke_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sim::cut {
namespace {

/// Height of an arc, mm, below which the arc counts as a line here, because its centre would have
/// no correct digits.
constexpr double kFlatMm = 1.0e-7;

bool is_line(const Stroke& stroke) {
  return std::abs(stroke.bulge) * drawing::distance(stroke.from, stroke.to) < 2.0 * kFlatMm;
}

/// The circle of an arc, with the sector of the circle that the arc covers.
struct CircleArc {
  explicit CircleArc(const Stroke& arc) {
    const Place chord = arc.to - arc.from;
    const double across = (1.0 - arc.bulge * arc.bulge) / (4.0 * arc.bulge);
    centre = 0.5 * (arc.from + arc.to) + across * Place{-chord.y(), chord.x()};
    first = arc.from - centre;
    radius = std::hypot(first.x(), first.y());
    sweep = 4.0 * std::atan(arc.bulge);
  }

  [[nodiscard]] bool holds(const Place& way) const {
    double angle = std::atan2(drawing::cross(first, way), drawing::dot(first, way));
    if (sweep < 0.0) angle = -angle;
    if (angle < 0.0) angle += 2.0 * std::numbers::pi;
    return angle <= std::abs(sweep);
  }

  Place centre{0.0, 0.0};
  Place first{0.0, 0.0};
  double radius = 0.0;
  double sweep = 0.0;
};

bool lines_cross(const Stroke& a, const Stroke& b) {
  const Place along_a = a.to - a.from;
  const Place along_b = b.to - b.from;
  const double b_from = drawing::cross(along_a, b.from - a.from);
  const double b_to = drawing::cross(along_a, b.to - a.from);
  const double a_from = drawing::cross(along_b, a.from - b.from);
  const double a_to = drawing::cross(along_b, a.to - b.from);
  return b_from * b_to < 0.0 && a_from * a_to < 0.0;
}

double inner_distance(const Stroke& line, const CircleArc& arc, double least) {
  const Place chord = line.to - line.from;
  const double square = chord.squaredNorm();
  if (square == 0.0) return least;
  const double foot_share = drawing::dot(arc.centre - line.from, chord) / square;
  const Place foot = line.from + foot_share * chord;
  const double height = drawing::distance(foot, arc.centre);
  const bool has_foot = foot_share > 0.0 && foot_share < 1.0;
  if (has_foot && height > 0.0) {
    const Place way = foot - arc.centre;
    if (arc.holds(way)) least = std::min(least, std::abs(height - arc.radius));
    if (arc.holds(-way)) least = std::min(least, height + arc.radius);
  }
  if (height > arc.radius) return least;
  const double reach = std::sqrt((arc.radius * arc.radius - height * height) / square);
  for (const double share : {foot_share - reach, foot_share + reach}) {
    if (share < 0.0 || share > 1.0) continue;
    if (arc.holds(line.from + share * chord - arc.centre)) return 0.0;
  }
  return least;
}

/// Returns the least of `least` and the distances between inner points of two arcs; 0 if the arcs
/// cross.
/// @pre the first circle is not larger than the second one, so that a crossing is computed without
/// loss of digits
double inner_distance(const CircleArc& a, const CircleArc& b, double least) {
  const Place way = b.centre - a.centre;
  const double apart = std::hypot(way.x(), way.y());
  // Concentric circles have the same distance everywhere, so `least`, which contains the ends of
  // the arcs, decides.
  if (apart == 0.0) return least;
  for (const double on_a : {1.0, -1.0}) {
    if (!a.holds(on_a * way)) continue;
    for (const double on_b : {1.0, -1.0}) {
      if (!b.holds(on_b * way)) continue;
      least = std::min(least, std::abs(apart + on_b * b.radius - on_a * a.radius));
    }
  }
  if (apart > a.radius + b.radius || apart < std::abs(a.radius - b.radius)) return least;
  const double along_mm =
      ((apart - b.radius) * (apart + b.radius) + a.radius * a.radius) / (2.0 * apart);
  const double along = along_mm / apart;
  const double aside =
      std::sqrt(std::max(0.0, (a.radius - along_mm) * (a.radius + along_mm))) / apart;
  for (const double side : {aside, -aside}) {
    const Place from_a = along * way + side * Place{-way.y(), way.x()};
    if (a.holds(from_a) && b.holds(from_a - way)) return 0.0;
  }
  return least;
}

}  // namespace

double distance_between(const Stroke& a, const Stroke& b) {
  const std::array to_ends{
      distance_to(a, b.from), distance_to(a, b.to), distance_to(b, a.from), distance_to(b, a.to)};
  const double least = *std::ranges::min_element(to_ends);
  const bool a_is_line = is_line(a);
  const bool b_is_line = is_line(b);
  if (a_is_line && b_is_line) return lines_cross(a, b) ? 0.0 : least;
  if (a_is_line) return inner_distance(a, CircleArc{b}, least);
  if (b_is_line) return inner_distance(b, CircleArc{a}, least);
  const CircleArc one{a};
  const CircleArc other{b};
  return one.radius <= other.radius ? inner_distance(one, other, least)
                                    : inner_distance(other, one, least);
}

}  // namespace sim::cut

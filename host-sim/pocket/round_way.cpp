#include "host-sim/pocket/round_way.hpp"

#include <cmath>
#include <numbers>

namespace sim::pocket {
namespace {

using cnc::left_normal;
using cnc::WideVec2;
using cnc::pocket::ToolCircle;
using cnc::pocket::Use;

constexpr double kHalfTurn = std::numbers::pi;
/// Greatest sweep of an arc, radians. A greater sweep, almost a loop, would be longer than the line
/// that it smooths.
constexpr double kNearlyALoop = 1.5 * kHalfTurn;

/// Returns the path whose arcs turn to the given sides. Returns none if the circles overlap too
/// much for a common tangent, or if an arc is nearly a loop.
std::optional<RoundWay> way_by_sides(
    const Pose& from, const Pose& to, double radius_mm, double first_side, double last_side) {
  const WideVec2 first_centre = from.place + first_side * radius_mm * left_normal(from.direction);
  const WideVec2 last_centre = to.place + last_side * radius_mm * left_normal(to.direction);
  const WideVec2 between = last_centre - first_centre;
  const double away = between.norm();
  // The distance is 0 if both arcs turn to the same side.
  const double crossing_mm = (first_side - last_side) * radius_mm;
  if (away <= std::abs(crossing_mm) || away == 0.0) return std::nullopt;
  const WideVec2 along = turned(between / away, std::asin(crossing_mm / away));
  const WideVec2 aside = radius_mm * left_normal(along);
  RoundWay way{
      .first = {first_centre, from.place, first_side, turn_to(first_side, from.direction, along)},
      .line_start = first_centre - first_side * aside,
      .last = {last_centre,
               last_centre - last_side * aside,
               last_side,
               turn_to(last_side, along, to.direction)},
      .end = to.place};
  if (way.first.turn > kNearlyALoop || way.last.turn > kNearlyALoop) return std::nullopt;
  way.length_mm =
      radius_mm * (way.first.turn + way.last.turn) + (way.last.start - way.line_start).norm();
  return way;
}

std::optional<RoundWay> shortest_way(const Pose& from,
                                     const Pose& to,
                                     const ToolCircle& disc,
                                     double radius_mm) {
  std::optional<RoundWay> best;
  for (const double first_side : {1.0, -1.0}) {
    for (const double last_side : {1.0, -1.0}) {
      const auto way = way_by_sides(from, to, radius_mm, first_side, last_side);
      if (!way || (best && best->length_mm <= way->length_mm)) continue;
      if (way->first.stays_in(disc) && way->last.stays_in(disc)) best = way;
    }
  }
  return best;
}

}  // namespace

bool is_in(const WideVec2& place, const ToolCircle& circle) {
  return (place - circle.centre).norm() <= circle.radius + kSamePlaceMm;
}

WideVec2 turned(const WideVec2& vector, double angle) {
  return std::cos(angle) * vector + std::sin(angle) * left_normal(vector);
}

double turn_between(const WideVec2& from, const WideVec2& to) {
  const double angle = std::atan2(cnc::cross(from, to), from.dot(to));
  return angle < 0.0 ? angle + 2.0 * kHalfTurn : angle;
}

double turn_to(double side, const WideVec2& from, const WideVec2& to) {
  return side > 0.0 ? turn_between(from, to) : turn_between(to, from);
}

WideVec2 Rounding::middle() const {
  return 0.5 * (start + end) - 0.5 * bulge * left_normal(end - start);
}

Rounding rounding_of(const WideVec2& before,
                     const WideVec2& corner,
                     const WideVec2& after,
                     double trim_mm) {
  const WideVec2 in = (corner - before).normalized();
  const WideVec2 out = (after - corner).normalized();
  const double turn = std::atan2(cnc::cross(in, out), in.dot(out));
  return {corner - trim_mm * in, corner + trim_mm * out, std::tan(0.25 * turn)};
}

WideVec2 RoundTurn::place_at(double share) const {
  return centre + turned(start - centre, side * share * turn);
}

/// Returns whether the arc stays in a disc. The point of an arc that is farthest from the disc's
/// centre is one of two: an end of the arc, or the arc's point in the direction away from the
/// disc's centre.
bool RoundTurn::stays_in(const ToolCircle& disc) const {
  if (!is_in(start, disc) || !is_in(place_at(1.0), disc)) return false;
  const WideVec2 outwards = centre - disc.centre;
  const double radius = (start - centre).norm();
  if (outwards.norm() + radius <= disc.radius + kSamePlaceMm) return true;
  return turn_to(side, start - centre, outwards) > turn;
}

void RoundTurn::write(DepthWriter& writer, const WideVec2& end) const {
  if ((writer.place() - end).norm() <= kSamePlaceMm) return;
  const double z = writer.floor_z();
  if (turn < kMinArc) return writer.go(Use::kReturn, end, 0.0, z);
  if (turn <= kHalfTurn) return writer.go(Use::kReturn, end, side * std::tan(0.25 * turn), z);
  const double bulge = side * std::tan(0.125 * turn);
  writer.go(Use::kReturn, place_at(0.5), bulge, z);
  writer.go(Use::kReturn, end, bulge, z);
}

void RoundWay::write(DepthWriter& writer) const {
  first.write(writer, line_start);
  writer.go_back(last.start);
  last.write(writer, end);
}

std::optional<RoundWay> round_way(const Pose& from,
                                  const Pose& to,
                                  const ToolCircle& disc,
                                  double radius_mm) {
  std::optional<RoundWay> way;
  for (double radius = radius_mm; !way && radius >= kMinTurnMm; radius *= 0.5) {
    way = shortest_way(from, to, disc, radius);
  }
  return way;
}

}  // namespace sim::pocket

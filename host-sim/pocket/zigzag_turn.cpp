#include "host-sim/pocket/zigzag_turn.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim::pocket {
namespace {

using cnc::WideVec2;

/// Greatest distance between the end of a turn and the wall, mm, by rounding.
constexpr double kMeetsMm = 1.0e-7;
/// Sine of the greatest angle between two tangents that count as one.
constexpr double kOneTangent = 1.0e-4;
/// Sweep below which an arc is omitted, radians.
constexpr double kNoSweep = 1.0e-6;

/// Returns the end of one of the stretches, on the given side, that is nearest to `x`. Returns none
/// if a stretch begins between this end and `x`. A line that ends at this point leaves only stock
/// within twice the radius of turns from the wall.
std::optional<double> end_nearest_to(const std::vector<Stretch>& stretches, double x, Side side) {
  std::optional<double> best;
  for (const Stretch& stretch : stretches) {
    const double end = end_of(stretch, side);
    if (!best || std::abs(end - x) < std::abs(*best - x)) best = end;
  }
  for (const Stretch& stretch : stretches) {
    const double begin = end_of(stretch, side == Side::kLeft ? Side::kRight : Side::kLeft);
    if ((begin - *best) * (begin - x) < 0.0) return std::nullopt;
  }
  return best;
}

/// Directions of a line or an arc at its beginning and at its end.
struct Directions {
  WideVec2 begin{1.0, 0.0};
  WideVec2 end{1.0, 0.0};
};

Directions directions_of(const WideVec2& from, const WayElement& element) {
  const WideVec2 chord = element.to - from;
  const double half_sweep = 2.0 * std::atan(element.bulge);
  const double cosine = std::cos(half_sweep) / chord.norm();
  const double sine = std::sin(half_sweep) / chord.norm();
  return {cosine * chord - sine * cnc::left_normal(chord),
          cosine * chord + sine * cnc::left_normal(chord)};
}

/// Returns the direction that leads out of the area on one side.
WideVec2 outwards(Side side) {
  return side == Side::kRight ? WideVec2{1.0, 0.0} : WideVec2{-1.0, 0.0};
}

bool lies_on(const Stretch& stretch, double x) {
  return x > stretch.from_x - kMeetsMm && x < stretch.to_x + kMeetsMm;
}

}  // namespace

/// With and without `leaves_line`, the arc turns left on the right side of the area, and right on
/// the left side.
std::optional<WallFillet> fillet_at(
    const TurnSpace& space, const Stretch& line, double y_mm, Side side, bool leaves_line) {
  const double centre_y = leaves_line ? y_mm + space.radius_mm : y_mm - space.radius_mm;
  const auto centre_x =
      end_nearest_to(stretches_at(space.centres, centre_y), end_of(line, side), side);
  if (!centre_x || !lies_on(line, *centre_x)) return std::nullopt;
  const WideVec2 centre{*centre_x, centre_y};
  const auto wall = space.rounded->nearest(centre);
  if (std::abs(wall.distance - space.radius_mm) > kMeetsMm) return std::nullopt;
  WallFillet fillet{{*centre_x, y_mm}, {wall.element, wall.point}, 0.0};
  if (space.radius_mm == 0.0) return fillet;
  const WideVec2 line_way = fillet.on_line - centre;
  const WideVec2 wall_way = wall.point - centre;
  // At a corner of the wall, the arc and the wall would have no common tangent.
  const WideVec2 along = space.rounded->element(wall.element).tangent_at(wall.point);
  if (std::abs(along.dot(wall_way)) > kOneTangent * space.radius_mm) return std::nullopt;
  const WideVec2& from = leaves_line ? line_way : wall_way;
  const WideVec2& to = leaves_line ? wall_way : line_way;
  const double sign = side == Side::kRight ? 1.0 : -1.0;
  const double sweep = sign * std::atan2(cnc::cross(from, to), from.dot(to));
  if (sweep < -kNoSweep) return std::nullopt;
  fillet.bulge = sweep < kNoSweep ? 0.0 : sign * std::tan(0.25 * sweep);
  return fillet;
}

bool is_smooth(const TurnSpace& space,
               const WideVec2& from,
               const WideVec2& begin,
               const std::vector<WayElement>& way,
               Side side) {
  WideVec2 direction = begin;
  WideVec2 at = from;
  for (const WayElement& element : way) {
    const WideVec2 chord = element.to - at;
    if (chord.norm() < kMeetsMm) continue;
    const Directions ends = directions_of(at, element);
    if (direction.dot(ends.begin) < 0.0) return false;
    if (std::abs(cnc::cross(direction, ends.begin)) > kOneTangent) return false;
    const WideVec2 middle = 0.5 * (at + element.to - element.bulge * cnc::left_normal(chord));
    if (space.rounded->depth(middle) < -kMeetsMm) return false;
    direction = ends.end;
    at = element.to;
  }
  const WideVec2 away = outwards(side);
  return std::abs(cnc::cross(direction, away)) <= kOneTangent && direction.dot(away) < 0.0;
}

std::optional<ZigzagTurn> turn_between(const TurnSpace& space,
                                       const StretchPair& pair,
                                       Side side,
                                       double limit_mm) {
  const auto& [below, above, y_mm, step_mm] = pair;
  const auto leaving = fillet_at(space, below, y_mm, side, true);
  const auto meeting = fillet_at(space, above, y_mm + step_mm, side, false);
  if (!leaving || !meeting) return std::nullopt;
  auto along =
      way_along(space.rounded, leaving->on_wall, meeting->on_wall, side == Side::kLeft, limit_mm);
  if (!along) return std::nullopt;
  ZigzagTurn turn{leaving->on_line.x(), meeting->on_line.x(), {}};
  turn.way.push_back({leaving->on_wall.place, leaving->bulge});
  turn.way.insert(turn.way.end(), along->begin(), along->end());
  turn.way.push_back({meeting->on_line, meeting->bulge});
  const bool has_corners =
      space.radius_mm > 0.0 && !is_smooth(space, leaving->on_line, outwards(side), turn.way, side);
  if (has_corners) return std::nullopt;
  return turn;
}

}  // namespace sim::pocket

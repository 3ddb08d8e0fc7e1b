#include "host-sim/pocket/round_return.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace sim::pocket {
namespace {

using cnc::left_normal;
using cnc::WideVec2;
using cnc::pocket::ToolCircle;
using cnc::pocket::Use;

/// Greatest turn of a corner that is rounded, radians. With a greater turn, the path nearly
/// reverses, and the corner stays.
constexpr double kNearlyBack = 0.95 * std::numbers::pi;

/// Returns the discs through whose centres the tool moves. Skips the discs whose centres are in the
/// disc in which the tool is.
std::vector<ToolCircle> shortened(const std::vector<ToolCircle>& way) {
  std::vector<ToolCircle> short_way;
  std::size_t disc = 0;
  while (disc + 1 < way.size()) {
    std::size_t next = disc;
    while (next + 1 < way.size() && is_in(way[next + 1].centre, way[disc])) ++next;
    if (next == disc) {
      if (short_way.empty()) short_way.push_back(way[disc]);
      ++next;
    }
    short_way.push_back(way[next]);
    disc = next;
  }
  if (short_way.empty()) short_way.push_back(way.back());
  return short_way;
}

/// Returns the discs without those inner discs whose centre coincides with the centre of a
/// neighbour, because no arc fits between such discs. The first and the last disc are kept.
std::vector<ToolCircle> without_repeats(const std::vector<ToolCircle>& discs) {
  // Greatest distance between coinciding centres; far below the tolerance of the axis.
  constexpr double kSameCentreMm = 1.0e-5;
  const auto is_same = [](const ToolCircle& a, const ToolCircle& b) {
    return (a.centre - b.centre).norm() <= kSameCentreMm;
  };
  std::vector<ToolCircle> kept{discs.front()};
  for (std::size_t i = 1; i + 1 < discs.size(); ++i) {
    if (!is_same(kept.back(), discs[i])) kept.push_back(discs[i]);
  }
  if (discs.size() == 1) return kept;
  if (kept.size() > 1 && is_same(kept.back(), discs.back())) kept.pop_back();
  kept.push_back(discs.back());
  return kept;
}

/// Returns an arc that turns to one side out of the direction of travel, so that a line leads from
/// its end to `target`. Returns none if the arc goes around `target`, or leaves the disc.
std::optional<RoundTurn> turn_by_side(
    const Pose& here, const ToolCircle& disc, const WideVec2& target, double turn_mm, double side) {
  const WideVec2 centre = here.place + side * turn_mm * left_normal(here.direction);
  const WideVec2 way = target - centre;
  const double away = way.norm();
  if (away <= turn_mm) return std::nullopt;
  const WideVec2 along = turned(way / away, side * std::asin(turn_mm / away));
  const RoundTurn arc{centre, here.place, side, turn_to(side, here.direction, along)};
  if (!arc.stays_in(disc)) return std::nullopt;
  return arc;
}

/// Turns by an arc out of the direction of travel towards `target`. The arc is the first element of
/// a path within a disc.
void turn_towards(DepthWriter& writer,
                  const ToolCircle& disc,
                  const WideVec2& target,
                  double turn_mm) {
  const Pose here{writer.place(), writer.heading()};
  if (here.direction == WideVec2{0.0, 0.0}) return;
  std::optional<RoundTurn> arc;
  for (double radius_mm = turn_mm; !arc && radius_mm >= kMinTurnMm; radius_mm *= 0.5) {
    for (const double side : {1.0, -1.0}) {
      const auto turn = turn_by_side(here, disc, target, radius_mm, side);
      if (turn && (!arc || turn->turn < arc->turn)) arc = turn;
    }
  }
  if (arc) arc->write(writer, arc->place_at(1.0));
}

/// Adds a line towards the centre of a disc, and near this centre an arc into the direction of the
/// next line.
void round_corner(DepthWriter& writer,
                  const ToolCircle& corner,
                  const WideVec2& next,
                  double turn_mm) {
  const WideVec2 before = corner.centre - writer.place();
  const WideVec2 after = next - corner.centre;
  const double trim = std::min({turn_mm, corner.radius, 0.5 * before.norm(), 0.5 * after.norm()});
  const double turn = std::atan2(cnc::cross(before, after), before.dot(after));
  const bool is_corner = trim < kMinTurnMm || std::abs(turn) > kNearlyBack;
  if (is_corner || std::abs(turn) < kMinArc) return writer.go_back(corner.centre);
  const Rounding arc = rounding_of(writer.place(), corner.centre, next, trim);
  writer.go_back(arc.start);
  writer.go(Use::kReturn, arc.end, arc.bulge, writer.floor_z());
}

}  // namespace

void go_through_round(DepthWriter& writer, const std::vector<ToolCircle>& way, double turn_mm) {
  const std::vector<ToolCircle> discs = without_repeats(shortened(way));
  const ToolCircle& here = way.front();
  const double first_turn_mm = std::min(turn_mm, kTurnOfCircle * here.radius);
  const bool begins_at_centre = discs.size() > 1 && discs.front().centre == here.centre;
  if (begins_at_centre) {
    const WideVec2 on = discs[1].centre - here.centre;
    go_back_round(writer, here, {here.centre, on.normalized()}, first_turn_mm);
  } else {
    turn_towards(writer, here, discs.front().centre, first_turn_mm);
  }
  for (std::size_t i = begins_at_centre ? 1 : 0; i + 1 < discs.size(); ++i) {
    round_corner(writer, discs[i], discs[i + 1].centre, turn_mm);
  }
  writer.go_back(discs.back().centre);
}

Approach approach_from(const WideVec2& place, const Pose& next, double radius_mm) {
  const WideVec2 centre = next.place + radius_mm * left_normal(next.direction);
  const WideVec2 way = centre - place;
  const double away = way.norm();
  if (away <= radius_mm) return {};
  const WideVec2 along = turned(way / away, -std::asin(radius_mm / away));
  const double turn = turn_between(along, next.direction);
  if (turn >= std::numbers::pi) return {};
  return {centre, centre - radius_mm * left_normal(along), turn, true};
}

double Approach::bulge() const { return turn < kMinArc ? 0.0 : std::tan(0.25 * turn); }

WideVec2 Approach::place_at(double share) const {
  return centre + turned(arc_start - centre, share * turn);
}

void go_back_round(DepthWriter& writer, const ToolCircle& disc, const Pose& next, double turn_mm) {
  Pose here{writer.place(), writer.heading()};
  // A null vector means that the tool is at rest and may start in any direction.
  if (here.direction == WideVec2{0.0, 0.0}) {
    const WideVec2 ahead = next.place - here.place;
    if (ahead.norm() <= kSamePlaceMm) return;
    here.direction = ahead.normalized();
  }
  const auto way = round_way(here, next, disc, turn_mm);
  if (way) {
    way->write(writer);
  } else {
    writer.go_back(next.place);
  }
}

}  // namespace sim::pocket

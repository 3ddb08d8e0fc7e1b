#include "firmware/machine/travel.hpp"

#include <algorithm>
#include <cmath>

namespace cnc {
namespace {

/// A circle that touches the end of the travel may be this much beyond it by
/// rounding: its radius is a float.
constexpr Coordinate kSlack{1000};

struct Arm {
  float x;
  float y;
};

float cross(const Arm& a, const Arm& b) { return a.x * b.y - a.y * b.x; }
float dot(const Arm& a, const Arm& b) { return a.x * b.x + a.y * b.y; }

/// Whether turning counter-clockwise from `start` to `end`, a full turn when
/// they agree, passes `arm`.
bool passes(const Arm& start, const Arm& end, const Arm& arm) {
  const float turn = cross(start, end);
  if (turn == 0.0F && dot(start, end) > 0.0F) return true;
  if (turn >= 0.0F) return cross(start, arm) >= 0.0F && (turn == 0.0F || cross(arm, end) >= 0.0F);
  return cross(end, arm) <= 0.0F || cross(arm, start) <= 0.0F;
}

}  // namespace

bool has_homing_option(const Settings& settings, unsigned option) {
  return (static_cast<unsigned>(settings.get(setting::kHoming)) & option) != 0;
}

AxisTravel travel_of(const Settings& settings, std::size_t axis) {
  const Coordinate length = from_mm(settings.get(setting::kTravel, axis));
  const auto mask = static_cast<unsigned>(settings.get(setting::kHomingDirectionInvert));
  const bool homes_low = (mask >> axis & 1U) != 0;
  const bool positive = homes_low && has_homing_option(settings, homing_option::kSetOrigin);
  return positive ? AxisTravel{.least = {}, .most = length}
                  : AxisTravel{.least = -length, .most = {}};
}

void Travel::configure(const Settings& settings, std::uint8_t homed) {
  judged_ = 0;
  if (settings.get(setting::kSoftLimits) == 0.0F) return;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto bit = static_cast<std::uint8_t>(1U << axis);
    if ((homed & bit) == 0 || settings.get(setting::kTravel, axis) <= 0.0F) continue;
    judged_ = static_cast<std::uint8_t>(judged_ | bit);
    const AxisTravel travel = travel_of(settings, axis);
    least_[axis] = travel.least;
    most_[axis] = travel.most;
  }
}

bool Travel::left_by(gcode::Actions actions, const Position& from) const {
  if (judged_ == 0) return false;
  Position here = from;
  for (const gcode::Action& action : actions) {
    switch (action.kind) {
      case gcode::ActionKind::kArc:
        if (!contains_arc(here, action)) return true;
        break;
      case gcode::ActionKind::kRapid:
      case gcode::ActionKind::kLine:
      case gcode::ActionKind::kProbe:
        if (!contains(action.end)) return true;
        break;
      default:
        continue;
    }
    here = action.end;
  }
  return false;
}

bool Travel::contains(const Position& place) const {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((judged_ >> axis & 1U) == 0) continue;
    if (place[axis] < least_[axis] - kSlack || place[axis] > most_[axis] + kSlack) return false;
  }
  return true;
}

/// The end, and each of the four outermost points of the circle on the way.
bool Travel::contains_arc(const Position& start, const gcode::Action& arc) const {
  if (!contains(arc.end)) return false;
  const PlaneAxes axes = axes_of(arc.plane);
  Arm from{(start[axes.first] - arc.centre[0]).mm(), (start[axes.second] - arc.centre[1]).mm()};
  Arm to{(arc.end[axes.first] - arc.centre[0]).mm(), (arc.end[axes.second] - arc.centre[1]).mm()};
  const float radius = std::sqrt(std::max(dot(from, from), dot(to, to)));
  const bool whole = arc.turns > 1 || (start[axes.first] == arc.end[axes.first] &&
                                       start[axes.second] == arc.end[axes.second]);
  if (arc.clockwise) std::swap(from, to);
  constexpr std::array<Arm, 4> kOutermost{
      {{1.0F, 0.0F}, {0.0F, 1.0F}, {-1.0F, 0.0F}, {0.0F, -1.0F}}};
  for (const Arm& arm : kOutermost) {
    if (!whole && !passes(from, to, arm)) continue;
    Position point = arc.end;
    point[axes.first] = arc.centre[0] + from_mm(radius * arm.x);
    point[axes.second] = arc.centre[1] + from_mm(radius * arm.y);
    if (arm.x == 0.0F) point[axes.first] = arc.end[axes.first];
    if (arm.y == 0.0F) point[axes.second] = arc.end[axes.second];
    if (!contains(point)) return false;
  }
  return true;
}

Position Travel::clamped(const Position& place) const {
  Position inside = place;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((judged_ >> axis & 1U) == 0) continue;
    inside[axis] = std::clamp(place[axis], least_[axis], most_[axis]);
  }
  return inside;
}

}  // namespace cnc

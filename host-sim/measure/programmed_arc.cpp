#include "host-sim/measure/programmed_arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Half of the smallest distance that the product can represent (1 nm), mm.
constexpr double kSamePlace = 0.5e-6;

/// Angle below which two directions count as equal, radians. It is the rounding error of a double
/// at 1 km.
constexpr double kSameDirection = 1.0e-12;

/// Greatest angle (radians) and greatest distance (mm) from start to end of a full circle whose end
/// was rounded.
constexpr double kRoundedTurn = 5.0e-7;
constexpr double kRoundedEnd = 1.0e-3;

struct Polar {
  double radius;
  double angle;
};

Polar polar_about_centre(const ProgrammedArc& arc, const Point& point) {
  const auto axes = cnc::axes_of(arc.plane);
  const double x = point[axes.first] - arc.centre[0];
  const double y = point[axes.second] - arc.centre[1];
  return {std::hypot(x, y), std::atan2(y, x)};
}

double chord_of(const ProgrammedArc& arc) {
  const auto axes = cnc::axes_of(arc.plane);
  return std::hypot(arc.end[axes.first] - arc.start[axes.first],
                    arc.end[axes.second] - arc.start[axes.second]);
}

Point division_point(const ProgrammedArc& arc, double sweep, double fraction) {
  const Polar start = polar_about_centre(arc, arc.start);
  const Polar end = polar_about_centre(arc, arc.end);
  const double radius = start.radius + fraction * (end.radius - start.radius);
  const double angle = start.angle + fraction * sweep;
  Point point{};
  for (std::size_t i = 0; i < point.size(); ++i) {
    point[i] = arc.start[i] + fraction * (arc.end[i] - arc.start[i]);
  }
  const auto axes = cnc::axes_of(arc.plane);
  point[axes.first] = arc.centre[0] + radius * std::cos(angle);
  point[axes.second] = arc.centre[1] + radius * std::sin(angle);
  return point;
}

}  // namespace

double start_radius(const ProgrammedArc& arc) { return polar_about_centre(arc, arc.start).radius; }

bool is_closed(const ProgrammedArc& arc) {
  const auto axes = cnc::axes_of(arc.plane);
  return std::abs(arc.end[axes.first] - arc.start[axes.first]) < kSamePlace &&
         std::abs(arc.end[axes.second] - arc.start[axes.second]) < kSamePlace;
}

double sweep_of(const ProgrammedArc& arc) {
  const double turn = arc.clockwise ? -1.0 : 1.0;
  double travelled = kTurn;
  if (!is_closed(arc)) {
    const double from = polar_about_centre(arc, arc.start).angle;
    travelled = turn * (polar_about_centre(arc, arc.end).angle - from);
    if (travelled < 0.0) travelled += kTurn;
    const bool is_rounded = travelled <= kRoundedTurn && chord_of(arc) <= kRoundedEnd;
    if (is_rounded || travelled < kSameDirection) travelled += kTurn;
  }
  return turn * (travelled + kTurn * std::max(0, arc.turns - 1));
}

std::vector<Curve> pieces_of(const ProgrammedArc& arc) {
  const double sweep = sweep_of(arc);
  const int count =
      std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / std::numbers::pi - 1.0e-9)));
  std::vector<Curve> pieces;
  pieces.reserve(static_cast<std::size_t>(count));
  Point from = arc.start;
  for (int i = 1; i <= count; ++i) {
    const Point to =
        i == count ? arc.end : division_point(arc, sweep, static_cast<double>(i) / count);
    pieces.push_back(Curve::arc(from, to, arc.plane, arc.centre, arc.clockwise));
    from = to;
  }
  return pieces;
}

std::array<double, 2> centre_from_radius(const ProgrammedArc& arc, double radius) {
  const auto axes = cnc::axes_of(arc.plane);
  const double half_x = (arc.end[axes.first] - arc.start[axes.first]) / 2.0;
  const double half_y = (arc.end[axes.second] - arc.start[axes.second]) / 2.0;
  const double half_chord = std::hypot(half_x, half_y);
  const double height = std::sqrt(std::max(0.0, radius * radius - half_chord * half_chord));
  // For the shorter arc, counter-clockwise, the centre is to the left of the chord.
  const double side = ((radius > 0.0) == arc.clockwise ? -height : height) / half_chord;
  return {arc.start[axes.first] + half_x - side * half_y,
          arc.start[axes.second] + half_y + side * half_x};
}

}  // namespace sim

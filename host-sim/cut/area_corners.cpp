#include "host-sim/cut/area_corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host-sim/cut/segment_distance.hpp"

namespace sim::cut {
namespace {

/// Greatest value of half the angle by which a path turns at one corner, radians.
constexpr double kLargestStep = 0.25 * std::numbers::pi;
constexpr double kTinyTurn = 1.0e-3;  ///< Turns below this angle are smooth, radians.
/// Sine of the angle by which AreaCorner::is_touched_from() is tolerant: about ten degrees.
constexpr double kTouchingSine = 0.17;
/// Least distance between a large arc and the corners around it, as a share of the radius of the
/// arc. A greater distance results in fewer corners.
constexpr double kShareOfRadius = 0.001;

Place turned_by(const Place& way, double angle) {
  return {std::cos(angle) * way.x() - std::sin(angle) * way.y(),
          std::sin(angle) * way.x() + std::cos(angle) * way.y()};
}

/// Adds the corners at which neighbouring tangents of an arc intersect. The arc turns left.
/// @param tangent unit direction at the start of the arc, with the centre on the left
void add_tangents(std::vector<AreaCorner>& corners,
                  const Place& centre,
                  double radius,
                  double sweep,
                  const Place& tangent,
                  double distance_mm) {
  const double off = std::max(0.5 * distance_mm, kShareOfRadius * radius);
  const double half = std::min(std::acos(radius / (radius + off)), kLargestStep);
  const double count = std::max(1.0, std::ceil(sweep / (2.0 * half)));
  const double step = sweep / count;
  for (double i = 0.0; i < count; i += 1.0) {
    const Place first = turned_by(tangent, i * step);
    const Place middle = turned_by(tangent, (i + 0.5) * step);
    corners.push_back({centre + radius / std::cos(0.5 * step) * right_of(middle),
                       first,
                       turned_by(tangent, (i + 1.0) * step)});
  }
}

}  // namespace

bool AreaCorner::is_touched_from(const Place& other) const {
  const Place way = other - place;
  const double least = -kTouchingSine * std::hypot(way.x(), way.y());
  return drawing::cross(arriving, way) >= least || drawing::cross(leaving, way) >= least;
}

std::vector<AreaCorner> corners_around(const LoopArea& area, double distance_mm) {
  // The distance is slightly larger than required. Otherwise rounding might bring a path along the
  // polygon too near to the area.
  const double away = area.skin_mm() + 1.001 * distance_mm + 1.0e-6;
  std::vector<AreaCorner> corners;
  const std::vector<Stroke>& loop = area.strokes();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Stroke& stroke = loop[i];
    const Stroke& next = loop[i + 1 < loop.size() ? i + 1 : 0];
    if (stroke.bulge > 0.0) {
      const Place centre = arc_centre(stroke);
      add_tangents(corners,
                   centre,
                   drawing::distance(centre, stroke.from) + away,
                   4.0 * std::atan(stroke.bulge),
                   tangent_at(stroke, 0.0),
                   distance_mm);
    }
    const Place arriving = tangent_at(stroke, 1.0);
    const Place leaving = tangent_at(next, 0.0);
    const double turn =
        std::atan2(drawing::cross(arriving, leaving), drawing::dot(arriving, leaving));
    if (turn > kTinyTurn) add_tangents(corners, stroke.to, away, turn, arriving, distance_mm);
  }
  return corners;
}

}  // namespace sim::cut

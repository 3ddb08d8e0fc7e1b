#include "planner/pocket/moving_disc.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::pocket {
namespace {

using contour::Curve;
using contour::FlatBox;

/// The motion of a disc as a function of the travelled length, mm.
struct DiscWay {
  WideVec2 from{0.0, 0.0};
  WideVec2 along{1.0, 0.0};
  double length = 0.0;
  double radius = 0.0;  ///< Radius at the start of the motion, mm.
  double growth = 0.0;  ///< Growth of the radius, mm per mm.

  [[nodiscard]] WideVec2 at(double s) const { return from + s * along; }
  [[nodiscard]] double radius_at(double s) const { return radius + growth * s; }
};

DiscWay way_of(const MovingDisc& disc) {
  const WideVec2 chord = disc.to - disc.from;
  const double length = chord.norm();
  if (length == 0.0) return {disc.from, {1.0, 0.0}, 0.0, disc.from_radius, 0.0};
  const double growth = (disc.to_radius - disc.from_radius) / length;
  return {disc.from, chord / length, length, disc.from_radius, growth};
}

/// Returns the travelled length at which the disc extends farthest beyond a point. If the disc
/// never reaches the point, this is the length at which the disc is nearest to it.
double max_across(const DiscWay& way, const WideVec2& point) {
  const WideVec2 ahead = point - way.from;
  const double foot = way.along.dot(ahead);
  const double aside = std::abs(cross(way.along, ahead));
  const double slope = std::max(0.0, 1.0 - way.growth * way.growth);
  const double lead = slope > 0.0 ? aside * way.growth / std::sqrt(slope) : 0.0;
  return std::clamp(foot + lead, 0.0, way.length);
}

/// Returns the length by which the disc extends across one element after it has travelled the
/// length `s`, mm; negative if the disc does not reach the element.
double excess_at(const DiscWay& way, double s, const Curve<double>& element) {
  return way.radius_at(s) - element.distance(way.at(s));
}

/// Returns the greatest excess across one element. Evaluates it at all lengths at which it may be
/// greatest.
double excess_across(const DiscWay& way, const Curve<double>& element) {
  double excess = std::max(excess_at(way, 0.0, element), excess_at(way, way.length, element));
  for (const WideVec2& end : {element.start, element.end}) {
    excess = std::max(excess, excess_at(way, max_across(way, end), element));
  }
  // For places outside the circle of an arc, the distance from the arc is the distance from the
  // centre minus the radius, which may have a minimum. Places inside the circle, and lines, add no
  // further minima.
  if (element.curvature != 0.0) {
    const WideVec2 centre = element.start + left_normal(element.start_tangent) / element.curvature;
    excess = std::max(excess, excess_at(way, max_across(way, centre), element));
  }
  return excess;
}

}  // namespace

double excess_of(const MovingDisc& disc, const AreaDistance& area) {
  const DiscWay way = way_of(disc);
  const double reach = std::max({0.0, disc.from_radius, disc.to_radius});
  const FlatBox<double> near{std::min(disc.from.x(), disc.to.x()) - reach,
                             std::min(disc.from.y(), disc.to.y()) - reach,
                             std::max(disc.from.x(), disc.to.x()) + reach,
                             std::max(disc.from.y(), disc.to.y()) + reach};
  double excess = 0.0;
  area.search(near, [&](const Curve<double>& element) {
    excess = std::max(excess, excess_across(way, element));
    return true;
  });
  return excess;
}

}  // namespace cnc::pocket

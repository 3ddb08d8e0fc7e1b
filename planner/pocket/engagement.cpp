#include "planner/pocket/engagement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/base/wide_scalar_math.hpp"

namespace cnc::pocket {
namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kQuarterTurn = 0.5 * kHalfTurn;

/// Returns the angle, radians, by which the range `middle` ± `half_width` overlaps the range of a
/// quarter turn on both sides of 0.
double part_ahead(double middle, double half_width) {
  double part = 0.0;
  for (const double turn : {-2.0 * kHalfTurn, 0.0, 2.0 * kHalfTurn}) {
    const double low = std::max(middle + turn - half_width, -kQuarterTurn);
    const double high = std::min(middle + turn + half_width, kQuarterTurn);
    part += std::max(0.0, high - low);
  }
  return part;
}

double arc_cosine(double cosine) {
  return wide_atan2(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), cosine);
}

/// Two circles that intersect, described in the direction from the first centre to the second
/// centre.
struct CirclePair {
  WideVec2 ahead{1.0, 0.0};
  /// Distance from the first centre to the chord between the two intersections.
  double along = 0.0;
  double aside = 0.0;  ///< Half of the length of the chord between the two intersections.
  /// Half of the sweep of the second circle's part outside the first circle, 0 to half a turn.
  double half_sweep = 0.0;
};

/// Returns the geometry of two circles that intersect. @pre the circles intersect
CirclePair pair_of(const ToolCircle& first, const ToolCircle& second) {
  const WideVec2 way = second.centre - first.centre;
  const double distance = way.norm();
  const double squares = (first.radius - second.radius) * (first.radius + second.radius);
  const double along = 0.5 * (distance + squares / distance);
  const double aside = std::sqrt(std::max(0.0, first.radius * first.radius - along * along));
  return {way / distance, along, aside, wide_atan2(aside, along - distance)};
}

}  // namespace

double engagement(const ClearedDisc& cleared,
                  double tool_radius_mm,
                  const WideVec2& place,
                  const WideVec2& direction) {
  const WideVec2 outwards = place - cleared.centre;
  const double away = outwards.norm();
  if (away + tool_radius_mm <= cleared.radius) return 0.0;
  if (std::abs(away - tool_radius_mm) >= cleared.radius) return kHalfTurn;
  const double squares = cleared.radius * cleared.radius - tool_radius_mm * tool_radius_mm;
  const double cosine = (squares - away * away) / (2.0 * away * tool_radius_mm);
  const double middle = wide_atan2(cross(direction, outwards), direction.dot(outwards));
  return part_ahead(middle, arc_cosine(std::clamp(cosine, -1.0, 1.0)));
}

Crescent crescent_between(const ToolCircle& cleared, const ToolCircle& next) {
  const double distance = (next.centre - cleared.centre).norm();
  const bool meet =
      distance > std::abs(cleared.radius - next.radius) && distance < cleared.radius + next.radius;
  if (!meet) return {};
  const CirclePair pair = pair_of(cleared, next);
  const WideVec2 chord = cleared.centre + pair.along * pair.ahead;
  const WideVec2 left = pair.aside * left_normal(pair.ahead);
  const WideSinCos quarter = sin_cos(0.25 * pair.half_sweep);
  return {.begin = chord - left,
          .middle = next.centre + next.radius * pair.ahead,
          .end = chord + left,
          .bulge = quarter.sine / quarter.cosine,
          .exists = true};
}

double crescent_engagement(const ToolCircle& cleared,
                           const ToolCircle& next,
                           double tool_radius_mm) {
  constexpr int kSamples = 64;  // Number of samples on each side of the crescent's middle.
  const ClearedDisc disc{cleared.centre, cleared.radius + tool_radius_mm};
  const CirclePair pair = pair_of(cleared, next);
  double greatest = 0.0;
  for (int i = -kSamples; i <= kSamples; ++i) {
    const WideSinCos turn = sin_cos(pair.half_sweep * i / kSamples);
    const WideVec2 out = turn.cosine * pair.ahead + turn.sine * left_normal(pair.ahead);
    const WideVec2 place = next.centre + next.radius * out;
    greatest = std::max(greatest, engagement(disc, tool_radius_mm, place, left_normal(out)));
  }
  return greatest;
}

}  // namespace cnc::pocket

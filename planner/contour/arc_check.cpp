#include "planner/contour/arc_check.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::contour {
namespace {

/// Shortest chord of an arc, mm. An arc with a shorter chord counts as a point.
constexpr double kPlaceChord = 1.0e-12;

/// Distance of a point of the curve from an arc, mm, and the derivative of this distance along the
/// curve.
struct ArcDistance {
  double mm = 0.0;
  double slope = 0.0;
};

ArcDistance distance_from(const Curve<double>& arc, const WayPoint& point) {
  if (arc.faces(point.place, 0.0)) {
    const WideVec2 right = -left_normal(arc.tangent_at(point.place));
    const double rightwards = right.dot(point.tangent);
    return {.mm = arc.from_circle(point.place),
            .slope = arc.side(point.place) < 0.0 ? -rightwards : rightwards};
  }
  const WideVec2 from_start = point.place - arc.start;
  const WideVec2 from_end = point.place - arc.end;
  const WideVec2 nearer = from_start.squaredNorm() < from_end.squaredNorm() ? from_start : from_end;
  const double mm = nearer.norm();
  return {.mm = mm, .slope = mm > 0.0 ? nearer.dot(point.tangent) / mm : 1.0};
}

bool is_half_a_turn_at_most(const Curve<double>& arc) {
  constexpr double kMinCosine = 1.0e-3;  // Least cosine of half the sweep of an arc.
  const WideVec2 chord = arc.end - arc.start;
  const double length = chord.norm();
  return length < kPlaceChord || chord.dot(arc.start_tangent) >= kMinCosine * length;
}

/// A sampled point of a stretch, and the distance of the point from the arc.
struct Seen {
  WayPoint point{};
  ArcDistance distance{};
};

/// Returns an upper bound of the distance from the arc between two points of a stretch. The slopes
/// of the distance at both points form a tent, and the top of the tent is the bound. Each slope is
/// made steeper by half of the difference of the slopes, because the slope may not be monotone
/// between the points.
double peak_between(const Seen& from, const Seen& to) {
  const double chord = (to.point.place - from.point.place).norm();
  const double margin = 0.5 * std::abs(to.distance.slope - from.distance.slope);
  const double up = std::max(0.0, from.distance.slope + margin);
  const double down = std::max(0.0, margin - to.distance.slope);
  const double whole = up + down;
  if (!(whole > 0.0)) return std::max(from.distance.mm, to.distance.mm);
  const double tent = (from.distance.mm * down + to.distance.mm * up + up * down * chord) / whole;
  return std::max({from.distance.mm, to.distance.mm, tent});
}

/// Returns whether a stretch is so short that its two ends show how the curve runs between them.
bool is_resolved(const Seen& from, const Seen& to, double fine_mm) {
  constexpr double kMinCosine = 0.99;
  // Upper limit of eight times the height of the distance function above the chord between its
  // ends, as a multiple of `fine_mm`.
  constexpr double kMaxBend = 100.0;
  const double chord = (to.point.place - from.point.place).norm();
  return from.point.tangent.dot(to.point.tangent) >= kMinCosine &&
         chord * std::abs(to.distance.slope - from.distance.slope) <= kMaxBend * fine_mm;
}

/// Returns the greatest distance between points of the stretch and the arc.
double stretch_deviation(const CurveStretch& stretch, const Curve<double>& arc, double fine_mm) {
  constexpr double kLargestStride = 1.0 / 16.0;  // Greatest step, in spans.
  // Greatest step as a share of the stretch. Such steps are short enough, because an arc touches
  // the edges of its band only a few times.
  constexpr double kLargestPart = 1.0 / 32.0;
  constexpr double kMinStride = 1.0e-14;
  const auto look = [&](double spans) {
    const WayPoint point = stretch.piece->at(spans);
    return Seen{.point = point, .distance = distance_from(arc, point)};
  };
  const double least = kMinStride * std::max(1.0, stretch.to);
  const double hopeless = 1.0e4 * fine_mm;
  const double most =
      std::max(least, std::min(kLargestStride, kLargestPart * (stretch.to - stretch.from)));
  double stride = most;
  double at = stretch.from;
  Seen before = look(at);
  double greatest = before.distance.mm;
  while (at < stretch.to && greatest < hopeless) {
    stride = std::clamp(stride, least, most);
    const double next = stretch.to - at <= 1.01 * stride ? stretch.to : at + stride;
    const Seen after = look(next);
    const Seen middle = look(0.5 * (at + next));
    const double peak = std::max(peak_between(before, middle), peak_between(middle, after));
    const double seen = std::max({greatest, before.distance.mm, after.distance.mm});
    const bool close = is_resolved(before, middle, fine_mm) &&
                       is_resolved(middle, after, fine_mm) && peak <= seen + fine_mm;
    if (!close && next - at > least) {
      stride = 0.5 * (next - at);
      continue;
    }
    greatest = std::max(seen, peak);
    at = next;
    before = after;
    stride *= 1.5;
  }
  return greatest;
}

}  // namespace

Curve<double> arc_leaving(const WideVec2& start, const WideVec2& tangent, const WideVec2& end) {
  const WideVec2 chord = end - start;
  const double square = chord.squaredNorm();
  if (square < kPlaceChord * kPlaceChord) return {start, end, tangent, tangent, 0.0};
  return {start,
          end,
          tangent,
          2.0 * tangent.dot(chord) / square * chord - tangent,
          2.0 * cross(tangent, chord) / square};
}

double arc_deviation(const CurveStretch& stretch, const Curve<double>& arc, double fine_mm) {
  constexpr double kMaxOfRadius = 0.98;
  if (!is_half_a_turn_at_most(arc)) return kNoArcFits;
  const double at_start = (arc.start - stretch.piece->at(stretch.from).place).norm();
  const double at_end = (arc.end - stretch.piece->at(stretch.to).place).norm();
  const double of_stretch = stretch_deviation(stretch, arc, fine_mm);
  const double greatest = std::max({of_stretch, at_start, at_end});
  const double size = std::abs(arc.curvature);
  // The radius of the arc is less than its distance from the stretch, or hardly greater. The bound
  // is then the diameter of the arc plus the deviation at its start, because no point of the arc is
  // farther from its start than the diameter.
  if (of_stretch * size > kMaxOfRadius) return std::max(greatest, at_start + 2.0 / size);
  return greatest;
}

}  // namespace cnc::contour

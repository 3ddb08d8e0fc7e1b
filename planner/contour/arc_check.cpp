#include "planner/contour/arc_check.hpp"

#include <algorithm>
#include <cmath>

namespace cnc {
namespace {

/// Below it an arc is a place.
constexpr double kPlaceChord = 1.0e-12;

/// What was seen of a stretch in one place.
struct Seen {
  WayPoint point{};
  BoundedArc::Distance distance{};
};

/// What the distance rises to between two places, at most: a tent over both slopes, each of them
/// steeper by half of what they differ, for slopes that are not monotone between.
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

/// Whether a stretch is short enough for its ends to tell what is between.
bool is_resolved(const Seen& from, const Seen& to, double fine_mm) {
  constexpr double kLeastCosine = 0.99;
  constexpr double kMostBend = 100.0;  // Eight times what it rises above its chord.
  const double chord = (to.point.place - from.point.place).norm();
  return from.point.tangent.dot(to.point.tangent) >= kLeastCosine &&
         chord * std::abs(to.distance.slope - from.distance.slope) <= kMostBend * fine_mm;
}

/// Of the places of the stretch from the arc.
double stretch_deviation(const CurveStretch& stretch, const BoundedArc& arc, double fine_mm) {
  constexpr double kLargestStride = 1.0 / 16.0;  // Spans.
  constexpr double kLargestPart = 1.0 / 32.0;    // An arc touches its band a few times.
  constexpr double kLeastStride = 1.0e-14;
  const auto look = [&](double spans) {
    const WayPoint point = stretch.piece->at(spans);
    return Seen{.point = point, .distance = arc.distance(point.place, point.tangent)};
  };
  const double least = kLeastStride * std::max(1.0, stretch.to);
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

BoundedArc::BoundedArc(const Vec2D& start, const Vec2D& start_tangent, const Vec2D& end)
    : circle_{start, start_tangent, 0.0}, end_{end}, end_tangent_{start_tangent} {
  const Vec2D chord = end - start;
  const double square = chord.squaredNorm();
  if (square < kPlaceChord * kPlaceChord) return;
  circle_.curvature = 2.0 * cross(start_tangent, chord) / square;
  end_tangent_ = 2.0 * start_tangent.dot(chord) / square * chord - start_tangent;
}

bool BoundedArc::is_half_a_turn_at_most() const {
  constexpr double kLeastCosine = 1.0e-3;  // Of half the sweep.
  const Vec2D chord = end_ - start();
  const double length = chord.norm();
  return length < kPlaceChord || chord.dot(circle_.tangent) >= kLeastCosine * length;
}

BoundedArc::Distance BoundedArc::distance(const Vec2D& place, const Vec2D& direction) const {
  const Vec2D from_start = place - circle_.point;
  const Vec2D from_end = place - end_;
  if (from_start.dot(circle_.tangent) >= 0.0 && from_end.dot(end_tangent_) <= 0.0) {
    const double across = circle_.across(place);
    const Vec2D left = (left_normal(circle_.tangent) - circle_.curvature * from_start).normalized();
    const double rightwards = -left.dot(direction);
    return {.mm = std::abs(across), .slope = across < 0.0 ? -rightwards : rightwards};
  }
  const Vec2D nearer = from_start.squaredNorm() < from_end.squaredNorm() ? from_start : from_end;
  const double mm = nearer.norm();
  return {.mm = mm, .slope = mm > 0.0 ? nearer.dot(direction) / mm : 1.0};
}

double arc_deviation(const CurveStretch& stretch, const BoundedArc& arc, double fine_mm) {
  constexpr double kMostOfRadius = 0.98;
  if (!arc.is_half_a_turn_at_most()) return kNoArcFits;
  const double at_start = (arc.start() - stretch.piece->at(stretch.from).place).norm();
  const double at_end = (arc.end() - stretch.piece->at(stretch.to).place).norm();
  const double of_stretch = stretch_deviation(stretch, arc, fine_mm);
  const double greatest = std::max({of_stretch, at_start, at_end});
  const double size = std::abs(arc.curvature());
  // Smaller than what it is away from: no place of it is farther than its diameter from its ends.
  if (of_stretch * size > kMostOfRadius) return std::max(greatest, at_start + 2.0 / size);
  return greatest;
}

}  // namespace cnc

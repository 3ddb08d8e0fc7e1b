#include "planner/geometry/arc_fit.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/base/scalar_math.hpp"

namespace cnc {
namespace {

/// Of the tolerance, what sampling may have missed.
constexpr float kUnseen = 0.005F;
/// Ends and joints are rounded to whole nanometres, the curve's own origin too.
constexpr float kRoundingMm = 2.0e-6F;
/// Of the extent: single precision of the sampled curve, the circles and the joint.
constexpr float kRelativeError = 3.0e-7F;

Vec2 between(const Position& from, const Position& to) {
  return {(to[0] - from[0]).mm(), (to[1] - from[1]).mm()};
}

float cube_root(float x) {
  // Newton's method from above; x in 1e-6…1e3 needs no more than a dozen steps.
  float root = x > 1.0F ? x : 1.0F;
  for (int i = 0; i < 16; ++i) root = (2.0F * root + x / (root * root)) * (1.0F / 3.0F);
  return root;
}

/// How much farther a biarc would get that may deviate by `allowed`: the
/// deviation grows with the third power of the length.
float growth(float allowed, float deviation) {
  constexpr float kLeast = 0.25F;
  constexpr float kMost = 3.0F;
  if (deviation >= BiarcTrial::kNoFit) return 0.4F;
  if (deviation * kMost * kMost * kMost <= allowed) return kMost;
  return std::max(kLeast, cube_root(allowed / deviation));
}

}  // namespace

ArcFit::ArcFit(const Spline& spline, const Position& start, float tolerance_mm)
    : ahead_{spline}, origin_{start}, here_{start}, tolerance_mm_{tolerance_mm} {
  CNC_ASSERT(tolerance_mm >= kLeastToleranceMm);
}

float ArcFit::allowed() const {
  return tolerance_mm_ * (1.0F - kUnseen) - kRoundingMm - kRelativeError * trial_.extent();
}

/// A bracket between what fits and what does not, narrowed by the cubic law of
/// `growth` and by halving.
ArcFit::Reach ArcFit::farthest() {
  constexpr float kPrecise = 0.004F;  // Of the reach: costs as much of the number of arcs.
  constexpr float kShort = 1.0e-6F;   // Knots; below, the parameter has no digits left.
  const float length = ahead_.length();
  const float guess = last_distance_ > 0.0F ? 1.1F * last_distance_ : length;
  Reach reach;
  float out_of_reach = length;
  bool bounded = false;
  float distance = std::min(guess, length);
  for (int i = 0; i < kMostTrials && distance > kShort; ++i) {
    distance = ahead_.expressible(distance);
    trial_.sample(ahead_, distance);
    const float most = allowed();
    const BiarcTrial::Fit fit = trial_.best(most);
    if (fit.deviation_mm <= most) {
      reach = {.distance = distance, .joint_share = fit.joint_share};
      if (distance >= length) break;
    } else {
      out_of_reach = distance;
      bounded = true;
      if (reach.distance <= 0.0F && trial_.extent() < 0.25F * tolerance_mm_) break;
    }
    if (bounded && out_of_reach - reach.distance <= kPrecise * out_of_reach) break;
    distance *= growth(most, fit.deviation_mm);
    if (bounded) {
      const float margin = 0.1F * (out_of_reach - reach.distance);
      distance = std::clamp(distance, reach.distance + margin, out_of_reach - margin);
    } else {
      distance = std::clamp(distance, 1.02F * reach.distance, length);
    }
  }
  return reach;
}

/// Looks more closely, and goes a little less far where that shows more.
ArcFit::Reach ArcFit::confirmed(Reach reach) {
  constexpr int kMostTimes = 16;
  constexpr float kLess = 0.99F;
  for (int i = 0; i < kMostTimes; ++i) {
    trial_.sample(ahead_, reach.distance);
    const float most = allowed();
    float found = trial_.deviation_closely(ahead_, reach.joint_share);
    if (found <= most) return reach;
    const BiarcTrial::Fit other = trial_.best(0.0F);
    if (i > 0 && other.deviation_mm <= most) {
      reach.joint_share = other.joint_share;
      found = trial_.deviation_closely(ahead_, reach.joint_share);
      if (found <= most) return reach;
    }
    reach.distance = ahead_.expressible(reach.distance * kLess * growth(most, found));
  }
  return {};
}

/// A last biarc much shorter than the one before would be all rounding, and a
/// corner to the planner: they share what is left.
ArcFit::Reach ArcFit::leave_no_crumb(const Reach& reach) {
  constexpr float kCrumb = 0.3F;
  const float rest = ahead_.length() - reach.distance;
  if (!ahead_.sees_end() || rest <= 0.0F || rest > kCrumb * reach.distance) return reach;
  return confirmed({.distance = ahead_.expressible((1.0F - kCrumb) * ahead_.length()),
                    .joint_share = reach.joint_share});
}

Position ArcFit::place_of(const PlanePlace& place) const {
  Position at = origin_;
  at[0] += Coordinate{place.x};
  at[1] += Coordinate{place.y};
  return at;
}

PathElement ArcFit::next() {
  CNC_ASSERT(!done());
  if (second_waits_) {
    second_waits_ = false;
    here_ = second_.end;
    return second_;
  }
  Reach reach = farthest();
  if (reach.distance > 0.0F) reach = leave_no_crumb(confirmed(reach));
  return reach.distance > 0.0F ? begin_biarc(reach) : go_straight();
}

/// Halves what is left until a line will do that is no longer than the bend
/// may be.
float ArcFit::straight_reach() {
  constexpr int kMostHalvings = 40;
  float distance = ahead_.length();
  for (int i = 0; i < kMostHalvings; ++i) {
    distance = ahead_.expressible(distance);
    trial_.sample(ahead_, distance);
    const bool short_enough = trial_.extent() <= tolerance_mm_;
    if (short_enough && trial_.deviation_of_line() <= allowed()) break;
    distance *= 0.5F;
  }
  return distance;
}

PathElement ArcFit::go_straight() {
  last_distance_ = ahead_.expressible(straight_reach());
  ahead_.advance(last_distance_);
  const PathElement line{.start = here_, .end = place_of(ahead_.place())};
  here_ = line.end;
  return line;
}

PathElement ArcFit::begin_biarc(const Reach& reach) {
  const Vec2 forward = ahead_.tangent();
  const Vec2 arrival = ahead_.arrival(reach.distance);
  last_distance_ = reach.distance;
  ahead_.advance(reach.distance);
  const Position end = place_of(ahead_.place());
  const BiarcEnds ends{.start = {0.0F, 0.0F},
                       .start_tangent = forward,
                       .end = between(here_, end),
                       .end_tangent = arrival.x() * forward + arrival.y() * left_normal(forward)};
  const PathElement lone{.start = here_, .end = end, .bulge = bulge_between(forward, ends.end)};
  const auto biarc = make_biarc(ends, reach.joint_share);
  if (!biarc.ok() || is_lone_arc(ends)) {
    here_ = end;
    return lone;
  }
  return divide(lone, ends, biarc.value().joint);
}

/// As seen from the chord the two tangents of a lone arc are mirror images.
bool ArcFit::is_lone_arc(const BiarcEnds& ends) const {
  constexpr float kSameCircle = 1.0e-5F;  // Radians: half of kLargestKink.
  const float leaving = bulge_between(ends.end, ends.end_tangent);
  const float kink = 2.0F * std::abs(leaving - bulge_between(ends.start_tangent, ends.end));
  return kink <= kSameCircle && kink * ends.end.norm() <= tolerance_mm_ * kUnseen;
}

/// Both tangents at the ends are met by the arcs with their joint rounded, so
/// that biarcs follow on each other without a corner; what rounding leaves of
/// one is at the joint.
PathElement ArcFit::divide(const PathElement& whole, const BiarcEnds& ends, const Vec2& joint) {
  PathElement first = whole;
  first.end = whole.start;
  first.end[0] += from_mm(joint.x());
  first.end[1] += from_mm(joint.y());
  second_ = whole;
  second_.start = first.end;
  first.bulge = bulge_between(ends.start_tangent, between(first.start, first.end));
  second_.bulge = bulge_between(between(second_.start, second_.end), ends.end_tangent);
  second_waits_ = true;
  here_ = first.end;
  return first;
}

}  // namespace cnc

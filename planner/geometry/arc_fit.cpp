#include "planner/geometry/arc_fit.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/base/scalar_math.hpp"

namespace cnc {
namespace {

/// Share of the tolerance by which a deviation between the samples may exceed the sampled
/// deviation.
constexpr float kUnseen = 0.005F;
/// Allowance for the rounding of ends, joints and the curve's own origin to whole nanometres, mm.
constexpr float kRoundingMm = 2.0e-6F;
/// Rounding error as a share of the extent (BiarcTrial::extent()). It covers the single precision
/// of the sampled curve, of the circles and of the joint.
constexpr float kRelativeError = 3.0e-7F;

Vec2 between(const Position& from, const Position& to) {
  return {(to[0] - from[0]).mm(), (to[1] - from[1]).mm()};
}

float rough_cube_root(float x) {
  // Newton's method, started above the root. For x in 1e-6…1e3 the 16 steps suffice.
  float root = x > 1.0F ? x : 1.0F;
  for (int i = 0; i < 16; ++i) root = (2.0F * root + x / (root * root)) * (1.0F / 3.0F);
  return root;
}

/// Returns the factor by which the length of a biarc with `deviation` may change so that the
/// deviation becomes `allowed`. The deviation grows with the third power of the length.
float growth(float allowed, float deviation) {
  constexpr float kMin = 0.25F;
  constexpr float kMax = 3.0F;
  if (deviation >= BiarcTrial::kNoFit) return 0.4F;
  if (deviation * kMax * kMax * kMax <= allowed) return kMax;
  return std::max(kMin, rough_cube_root(allowed / deviation));
}

}  // namespace

ArcFit::ArcFit(const Spline& spline, const Position& start, float tolerance_mm)
    : ahead_{spline}, origin_{start}, here_{start}, tolerance_mm_{tolerance_mm} {
  CNC_ASSERT(tolerance_mm >= kMinToleranceMm);
  begin();
}

float ArcFit::allowed() const {
  return tolerance_mm_ * (1.0F - kUnseen) - kRoundingMm - kRelativeError * trial_.extent();
}

void ArcFit::begin() {
  const float length = ahead_.length();
  const float guess = last_distance_ > 0.0F ? 1.1F * last_distance_ : length;
  step_ = Step::kReach;
  times_ = 0;
  reach_ = {};
  distance_ = std::min(guess, length);
  out_of_reach_ = length;
  bounded_ = false;
  crumb_seen_ = false;
}

bool ArcFit::work(std::uint32_t& points) {
  CNC_ASSERT(!done());
  while (!second_waits_ && step_ != Step::kReady && points > 0) {
    points -= std::min(points, do_step());
  }
  return second_waits_ || step_ == Step::kReady;
}

/// Does one step of the work. Returns the number of points of the curve that were used, at most
/// kPointsAtOnce.
std::uint32_t ArcFit::do_step() {
  switch (step_) {
    case Step::kReach:
      return reach_farther();
    case Step::kConfirm:
      return confirm();
    case Step::kOther:
      return look_for_other();
    case Step::kConfirmOther:
      return confirm_other();
    case Step::kStraight:
      return reach_straight();
    case Step::kReady:
      return 0;
  }
  return 0;
}

/// Tries one distance along the curve. The bracket is between a distance that fits and a distance
/// that does not fit. It is narrowed by the cubic law of `growth` and by halving. Returns the
/// number of points used.
std::uint32_t ArcFit::reach_farther() {
  constexpr std::uint8_t kMaxTimes = 28;
  // Shortest distance, in knots. A shorter distance is below the resolution of the parameter.
  constexpr float kShort = 1.0e-6F;
  if (times_ == kMaxTimes || distance_ <= kShort) {
    end_reach();
    return 0;
  }
  ++times_;
  distance_ = ahead_.expressible(distance_);
  trial_.sample(ahead_, distance_);
  const float most = allowed();
  const BiarcTrial::Fit fit = trial_.best(most);
  if (narrow(fit, most)) end_reach();
  return BiarcTrial::kSamples * (1 + fit.biarcs);
}

/// Narrows the bracket with the result of a trial. Returns whether the bracket is narrow enough.
bool ArcFit::narrow(const BiarcTrial::Fit& fit, float most) {
  // Width of the bracket as a share of the reach. The number of arcs grows by at most about this
  // share.
  constexpr float kPrecise = 0.004F;
  const float length = ahead_.length();
  if (fit.deviation_mm <= most) {
    reach_ = {.distance = distance_, .joint_share = fit.joint_share};
    if (distance_ >= length) return true;
  } else {
    out_of_reach_ = distance_;
    bounded_ = true;
    if (reach_.distance <= 0.0F && trial_.extent() < 0.25F * tolerance_mm_) return true;
  }
  if (bounded_ && out_of_reach_ - reach_.distance <= kPrecise * out_of_reach_) return true;
  distance_ *= growth(most, fit.deviation_mm);
  if (bounded_) {
    const float margin = 0.1F * (out_of_reach_ - reach_.distance);
    distance_ = std::clamp(distance_, reach_.distance + margin, out_of_reach_ - margin);
  } else {
    distance_ = std::clamp(distance_, 1.02F * reach_.distance, length);
  }
  return false;
}

void ArcFit::end_reach() {
  if (reach_.distance <= 0.0F) return begin_straight();
  step_ = Step::kConfirm;
  times_ = 0;
}

/// Compares the biarc more closely with the curve. If the deviation is too large, reduces the
/// distance that the biarc covers. Returns the number of points used.
std::uint32_t ArcFit::confirm() {
  constexpr std::uint8_t kMaxTimes = 16;
  if (times_ == kMaxTimes) {
    reach_ = {};
    end_confirm();
    return 0;
  }
  trial_.sample(ahead_, reach_.distance);
  found_mm_ = trial_.deviation_closely(ahead_, reach_.joint_share);
  if (found_mm_ <= allowed()) {
    end_confirm();
  } else if (times_ == 0) {
    go_less_far();
  } else {
    step_ = Step::kOther;
  }
  return BiarcTrial::kSamples + BiarcTrial::kClosely;
}

/// Tries another joint if a shorter distance alone did not reduce the deviation enough. Returns the
/// number of points used.
std::uint32_t ArcFit::look_for_other() {
  const BiarcTrial::Fit other = trial_.best(0.0F);
  if (other.deviation_mm <= allowed()) {
    reach_.joint_share = other.joint_share;
    step_ = Step::kConfirmOther;
  } else {
    go_less_far();
  }
  return BiarcTrial::kSamples * other.biarcs;
}

std::uint32_t ArcFit::confirm_other() {
  found_mm_ = trial_.deviation_closely(ahead_, reach_.joint_share);
  if (found_mm_ <= allowed()) {
    end_confirm();
  } else {
    go_less_far();
  }
  return BiarcTrial::kClosely;
}

void ArcFit::go_less_far() {
  constexpr float kLess = 0.99F;
  reach_.distance = ahead_.expressible(reach_.distance * kLess * growth(allowed(), found_mm_));
  ++times_;
  step_ = Step::kConfirm;
}

/// Ends the confirmation. Rounding would dominate a last biarc that is much shorter than the biarc
/// before it, and the planner would find a corner there. So the last two biarcs share the rest of
/// the curve.
void ArcFit::end_confirm() {
  constexpr float kCrumb = 0.3F;
  const float rest = ahead_.length() - reach_.distance;
  const bool crumb = ahead_.sees_end() && rest > 0.0F && rest <= kCrumb * reach_.distance;
  if (crumb && !crumb_seen_) {
    crumb_seen_ = true;
    reach_.distance = ahead_.expressible((1.0F - kCrumb) * ahead_.length());
    times_ = 0;
    step_ = Step::kConfirm;
  } else if (reach_.distance > 0.0F) {
    step_ = Step::kReady;
  } else {
    begin_straight();
  }
}

void ArcFit::begin_straight() {
  distance_ = ahead_.length();
  times_ = 0;
  step_ = Step::kStraight;
}

/// Halves the rest of the curve until a line fits whose length is at most the tolerance. Returns
/// the number of points used.
std::uint32_t ArcFit::reach_straight() {
  constexpr std::uint8_t kMaxHalvings = 40;
  distance_ = ahead_.expressible(distance_);
  trial_.sample(ahead_, distance_);
  const bool short_enough = trial_.extent() <= tolerance_mm_;
  if (short_enough && trial_.deviation_of_line() <= allowed()) {
    step_ = Step::kReady;
  } else {
    distance_ *= 0.5F;
    if (++times_ == kMaxHalvings) step_ = Step::kReady;
  }
  return 2 * BiarcTrial::kSamples;
}

PathElement ArcFit::next() {
  CNC_ASSERT(!done());
  if (second_waits_) {
    second_waits_ = false;
    here_ = second_.end;
    return second_;
  }
  while (step_ != Step::kReady) static_cast<void>(do_step());
  const PathElement element = reach_.distance > 0.0F ? begin_biarc(reach_) : go_straight();
  begin();
  return element;
}

Position ArcFit::place_of(const PlanePlace& place) const {
  Position at = origin_;
  at[0] += Coordinate{place.x};
  at[1] += Coordinate{place.y};
  return at;
}

PathElement ArcFit::go_straight() {
  last_distance_ = ahead_.expressible(distance_);
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
  const bool too_short = !biarc.ok() && biarc.error() == BiarcError::kChordTooShort;
  if (too_short || is_lone_arc(ends)) {
    here_ = end;
    return lone;
  }
  return divide(lone, ends, biarc.ok() ? biarc.value().joint : joint_of_trial(forward, reach));
}

/// Returns the joint of the biarc that was compared with the curve, relative to the start of the
/// biarc. This joint is used if no biarc exists between the rounded ends. That can happen if one of
/// the arcs is nearly half a turn.
Vec2 ArcFit::joint_of_trial(const Vec2& forward, const Reach& reach) const {
  const auto biarc = make_biarc(trial_.ends(), reach.joint_share);
  const Vec2 joint = biarc.ok() ? biarc.value().joint : Vec2{0.5F * trial_.ends().end};
  const Vec2 along = forward.normalized();
  return joint.x() * along + joint.y() * left_normal(along);
}

/// Returns whether a single arc can replace both arcs. The end tangents of a single arc are mirror
/// images with respect to its chord.
bool ArcFit::is_lone_arc(const BiarcEnds& ends) const {
  constexpr float kSameCircle = 1.0e-5F;  // Greatest kink in radians; half of kLargestKink.
  const float leaving = bulge_between(ends.end, ends.end_tangent);
  const float kink = 2.0F * std::abs(leaving - bulge_between(ends.start_tangent, ends.end));
  return kink <= kSameCircle && kink * ends.end.norm() <= tolerance_mm_ * kUnseen;
}

/// Divides an element at a rounded joint into two arcs. Returns the first arc and stores the second
/// arc for the next call of next(). The arcs have the given tangents at both ends, so that
/// consecutive biarcs meet without a corner. The kink that rounding leaves is at the joint.
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

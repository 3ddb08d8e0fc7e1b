#include "planner/path/corner.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/path/blend_deviation.hpp"

namespace cnc::path {
namespace {

/// Ends are rounded to nanometres, and single precision places them.
constexpr float kRoundingMm = 3.0e-6F;
constexpr float kRelativeRounding = 4.0e-7F;  // Of the trim.

/// An arc beside a corner is not trimmed by more than this many radians, which
/// keeps the distances that are compared smooth.
constexpr float kMostTurnOfLeg = 0.5F;

float tangent_of(float angle) {
  const SinCos of = sin_cos(angle);
  return of.sine / of.cosine;
}

float slope_square(const Leg& leg) {
  float sum = 0.0F;
  for (const float share : leg.slope) sum += square(share);
  return sum;
}

/// (Radians by which it turns off the plane)², as if it did not turn in it.
float turn_square_off_plane(const Leg& before, const Leg& after) {
  const float of_before = 1.0F / std::sqrt(1.0F + slope_square(before));
  const float of_after = 1.0F / std::sqrt(1.0F + slope_square(after));
  float sum = square(of_before - of_after);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    sum += square(of_before * before.slope[axis] - of_after * after.slope[axis]);
  }
  return sum;
}

/// Whether the axes off the plane go on as they came, round the corner too: the
/// blend is shorter than what it replaces, so their slope on it is steeper.
bool rides_along(const Corner& corner) {
  const float off_plane = turn_square_off_plane(corner.before, corner.after);
  if (off_plane > square(0.25F * motion::kTangentTurn)) return false;
  const float slope = slope_square(corner.before);
  if (slope == 0.0F) return true;
  const float half = 0.5F * std::abs(corner.turn);
  if (half > 1.0F) return false;
  // Of straight legs; half the allowance is left for what curved ones add.
  const float allowed = motion::kTangentTurn * (1.0F + slope);
  return std::sqrt(slope) * (tangent_of(half) / half - 1.0F) <= 0.5F * allowed;
}

bool lay_out(const PathElement& before, const PathElement& after, Plane plane, Corner& corner) {
  const auto left = leg_before(before, plane);
  const auto right = leg_after(after, plane);
  if (!left || !right) return false;
  corner.plane = plane;
  corner.before = *left;
  corner.after = *right;
  corner.turn = atan2_f(cross(left->tangent, right->tangent), left->tangent.dot(right->tangent));
  return rides_along(corner);
}

/// Of the first plane in which the corner is one.
bool lay_out(const PathElement& before, const PathElement& after, Corner& corner) {
  for (const Plane plane : {Plane::kXY, Plane::kZX, Plane::kYZ}) {
    if (lay_out(before, after, plane, corner)) return true;
  }
  return false;
}

/// Radius at which v²/R is a quarter of the acceleration at the programmed feed,
/// and so all of it when the operator doubles it.
float useful_radius(const Corner& corner, float feed, const motion::Limits& limits) {
  constexpr float kShare = 4.0F;
  const PlaneAxes axes = axes_of(corner.plane);
  const float rate =
      std::max(motion::motor_rate(limits, axes.first), motion::motor_rate(limits, axes.second));
  const float speed = feed > 0.0F ? std::min(feed, rate) : rate;
  const float acceleration =
      std::min(limits.acceleration_mm_s2[axes.first], limits.acceleration_mm_s2[axes.second]);
  return kShare * square(speed) / acceleration;
}

/// What the tolerance leaves where both legs are straight: the arc is
/// trim · tan(turn / 4) away from the corner.
float straight_trim(const Corner& corner, float most_mm) {
  const float share = tangent_of(0.25F * std::abs(corner.turn)) + kRelativeRounding;
  return std::min(most_mm, (corner.tolerance_mm - kRoundingMm) / share);
}

float chord_of(const PathElement& element) {
  float sum = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    sum += square((element.end[axis] - element.start[axis]).mm());
  }
  return std::sqrt(sum);
}

/// Radians that are no corner.
float smooth_turn(const PathItem& before, const PathItem& after) {
  if (!after.continues) return motion::kTangentTurn;
  const float shorter = std::min(chord_of(before.request.element), chord_of(after.request.element));
  const float rounding = kRoundedPlaceMm / std::max(shorter, kRoundedPlaceMm);
  return std::min(kSmoothTurn, motion::kTangentTurn + rounding);
}

bool turns_too_tightly(const Corner& corner, float trim_mm) {
  const BiarcEnds ends = ends_of(corner, trim_mm);
  return (ends.end - ends.start).norm() < kCrumbMm;
}

}  // namespace

bool stop_between(const PathItem& before, const PathItem& after) {
  const motion::MotionRequest& a = before.request;
  const motion::MotionRequest& b = after.request;
  const bool rapid_and_feed = (a.feed_mm_s <= 0.0F) != (b.feed_mm_s <= 0.0F);
  return rapid_and_feed || a.fixed_feed || b.fixed_feed;
}

BiarcEnds ends_of(const Corner& corner, float trim_mm) {
  return {.start = corner.before.place(-trim_mm),
          .start_tangent = corner.before.tangent_at(-trim_mm),
          .end = corner.after.place(trim_mm),
          .end_tangent = corner.after.tangent_at(trim_mm)};
}

/// The deviation grows about in proportion to the trim beside straight legs, and
/// with its square beside curved ones.
float fitting_trim(const Corner& corner, float most_mm) {
  constexpr int kMostTrials = 12;
  constexpr float kLeastShrink = 0.2F;
  constexpr float kMostShrink = 0.9F;
  float trim = straight_trim(corner, most_mm);
  if (trim < kCrumbMm) return 0.0F;
  if (corner.is_straight()) return turns_too_tightly(corner, trim) ? 0.0F : trim;
  for (const Leg* leg : {&corner.before, &corner.after}) {
    trim = std::min(trim, kMostTurnOfLeg / std::max(std::abs(leg->curvature), 1.0e-6F));
  }
  for (int i = 0; i < kMostTrials && trim >= kCrumbMm; ++i) {
    const float allowed = corner.tolerance_mm - kRoundingMm - kRelativeRounding * trim;
    const float deviation = blend_deviation(corner, trim);
    if (deviation <= allowed) return turns_too_tightly(corner, trim) ? 0.0F : trim;
    trim *= std::clamp(0.95F * allowed / deviation, kLeastShrink, kMostShrink);
  }
  return 0.0F;
}

Corner examine(const PathItem& before, const PathItem& after, const motion::Limits& limits) {
  using enum Corner::Kind;
  Corner corner;
  const motion::MotionRequest& old = before.request;
  const motion::MotionRequest& next = after.request;
  const float turn = motion::turn_square(end_direction(old.element), start_direction(next.element));
  if (turn <= square(smooth_turn(before, after))) {
    corner.kind = kSmooth;
    return corner;
  }
  corner.tolerance_mm = std::min(before.tolerance.corner_mm, after.tolerance.corner_mm);
  if (corner.tolerance_mm <= kRoundingMm || stop_between(before, after)) return corner;
  if (!lay_out(old.element, next.element, corner)) return corner;
  const float feed = std::max(old.feed_mm_s, next.feed_mm_s);
  const float half = 0.5F * std::abs(corner.turn);
  const float useful =
      half < 1.5F ? useful_radius(corner, feed, limits) * tangent_of(half) : 1.0e6F;
  const float most = std::min({useful, corner.before.length, corner.after.length});
  corner.wish_mm = fitting_trim(corner, most);
  if (corner.wish_mm > 0.0F) corner.kind = kBlend;
  return corner;
}

}  // namespace cnc::path

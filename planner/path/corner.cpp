#include "planner/path/corner.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/block/axes_in_plane.hpp"
#include "planner/path/blend_deviation.hpp"

namespace cnc::path {
namespace {

/// Allowance for the rounding of ends to nanometres and for the rounding of single precision, mm.
constexpr float kRoundingMm = 3.0e-6F;
// Additional allowance for single precision as a share of the trim.
constexpr float kRelativeRounding = 4.0e-7F;

/// Greatest angle, in radians, by which an arc next to a corner may turn within the trim. Up to
/// this angle, the distances that blend_deviation() samples change smoothly.
constexpr float kMaxTurnOfLeg = 0.5F;

/// Computes the geometry of a corner, and returns the plane in which the direction turns. Returns
/// nothing if there is no such plane.
std::optional<ArcPlane> lay_out(const PathElement& before,
                                const PathElement& after,
                                Corner& corner) {
  const auto left = leg_before(before);
  const auto right = leg_after(after);
  if (!left || !right) return std::nullopt;
  corner.before = *left;
  corner.after = *right;
  const auto plane = corner.plane();
  if (!plane) return std::nullopt;
  const Vec2 old = plane->seen(left->direction(0.0F));
  const Vec2 next = plane->seen(right->direction(0.0F));
  corner.turn = atan2_f(cross(old, next), old.dot(next));
  return plane;
}

/// Returns the radius at which v²/R, at the programmed feed, is a quarter of the acceleration. At
/// twice that feed, which is the greatest override, it is the whole acceleration.
float useful_radius(const ArcPlane& plane, float feed, const motion::Limits& limits) {
  constexpr float kShare = 4.0F;
  // Axes with a smaller share in the plane are left out. Each plane has at least one axis with a
  // greater share.
  constexpr float kMuch = 0.5F;
  float rate = 0.0F;
  float acceleration = 1.0e9F;
  for (const motion::AxisInPlane& each : motion::AxesInPlane{plane, 1.0F}) {
    acceleration = std::min(acceleration, limits.acceleration_mm_s2[each.axis] / each.size);
    if (each.size < kMuch) continue;
    rate = std::max(rate, motion::motor_rate(limits, each.axis) / each.size);
  }
  const float speed = feed > 0.0F ? std::min(feed, rate) : rate;
  return kShare * square(speed) / acceleration;
}

/// Returns the greatest trim that the tolerance permits between straight legs. The distance of the
/// arc from the corner is trim · tan(turn / 4).
float straight_trim(const Corner& corner, float max_mm) {
  const float share = tangent_of(0.25F * std::abs(corner.turn)) + kRelativeRounding;
  return std::min(max_mm, (corner.tolerance_mm - kRoundingMm) / share);
}

float chord_of(const PathElement& element) {
  return norm(travel_between(element.start, element.end));
}

/// Returns the greatest change of direction, in radians, that does not count as a corner.
float smooth_turn(const PathItem& before, const PathItem& after) {
  if (!after.continues) return motion::kTangentTurn;
  const float shorter = std::min(chord_of(before.request.element), chord_of(after.request.element));
  const float rounding = kRoundedPlaceMm / std::max(shorter, kRoundedPlaceMm);
  return std::min(kSmoothTurn, motion::kTangentTurn + rounding);
}

bool turns_too_tightly(const Corner& corner, float trim_mm) {
  const AxisVector start = corner.before.place(-trim_mm);
  return norm(sum_of(corner.after.place(trim_mm), -1.0F, start)) < kCrumbMm;
}

}  // namespace

bool stop_between(const PathItem& before, const PathItem& after) {
  const motion::MotionRequest& a = before.request;
  const motion::MotionRequest& b = after.request;
  const bool rapid_and_feed = (a.feed_mm_s <= 0.0F) != (b.feed_mm_s <= 0.0F);
  return rapid_and_feed || a.fixed_feed || b.fixed_feed;
}

/// Searches by trial: the deviation is about proportional to the trim if the legs are straight, and
/// to the square of the trim if a leg is curved.
float fitting_trim(const Corner& corner, float max_mm) {
  constexpr int kMaxTrials = 12;
  constexpr float kMinShrink = 0.2F;
  constexpr float kMaxShrink = 0.9F;
  float trim = straight_trim(corner, max_mm);
  if (trim < kCrumbMm) return 0.0F;
  if (corner.is_straight()) return turns_too_tightly(corner, trim) ? 0.0F : trim;
  for (const Leg* leg : {&corner.before, &corner.after}) {
    const float turn_by_mm = std::abs(leg->curvature) * leg->plane_share;
    trim = std::min(trim, kMaxTurnOfLeg / std::max(turn_by_mm, 1.0e-6F));
  }
  for (int i = 0; i < kMaxTrials && trim >= kCrumbMm; ++i) {
    const float allowed = corner.tolerance_mm - kRoundingMm - kRelativeRounding * trim;
    const float deviation = blend_deviation(corner, trim);
    if (deviation <= allowed) return turns_too_tightly(corner, trim) ? 0.0F : trim;
    trim *= std::clamp(0.95F * allowed / deviation, kMinShrink, kMaxShrink);
  }
  return 0.0F;
}

void examine(const PathItem& before,
             const PathItem& after,
             const motion::Limits& limits,
             Corner& corner) {
  using enum Corner::Kind;
  corner.kind = kStop;
  const motion::MotionRequest& old = before.request;
  const motion::MotionRequest& next = after.request;
  const float turn = motion::turn_square(end_direction(old.element), start_direction(next.element));
  if (turn <= square(smooth_turn(before, after))) {
    corner.kind = kSmooth;
    return;
  }
  corner.tolerance_mm =
      std::min(before.tolerance.corner_mm, after.tolerance.corner_mm) - after.aside_mm;
  if (corner.tolerance_mm <= kRoundingMm || stop_between(before, after)) return;
  const auto plane = lay_out(old.element, next.element, corner);
  if (!plane) return;
  const float feed = std::max(old.feed_mm_s, next.feed_mm_s);
  const float half = 0.5F * std::abs(corner.turn);
  const float useful =
      half < 1.5F ? useful_radius(*plane, feed, limits) * tangent_of(half) : 1.0e6F;
  const float most = std::min({useful, corner.before.length, corner.after.length});
  corner.wish_mm = fitting_trim(corner, most);
  if (corner.wish_mm > 0.0F) corner.kind = kBlend;
}

}  // namespace cnc::path

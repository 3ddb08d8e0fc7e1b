#include "planner/path/circle_fit.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::path {

FitFrame frame_in_space(const Vec3& ahead, const Vec3& towards) {
  /// Share of the tolerance in the plane of the bend. It is large, because a curve that bends in
  /// one direction leaves its plane only a little.
  constexpr float kLeftShare = 0.9F;
  /// Share of the tolerance perpendicular to this plane.
  constexpr float kUpShare = 0.4358F;
  constexpr float kEvenShare = 0.7071F;
  constexpr float kMin = 1.0e-4F;
  FitFrame frame{.ahead = ahead, .left_share = kLeftShare, .up_share = kUpShare};
  Vec3 left = towards - towards.dot(ahead) * ahead;
  if (left.norm() < kMin) {
    frame.left_share = frame.up_share = kEvenShare;
    // Axis with the smallest component along `ahead`.
    const Vec3 shares = ahead.cwiseAbs();
    const bool x_least = shares.x() <= shares.y() && shares.x() <= shares.z();
    const bool y_least = !x_least && shares.y() <= shares.z();
    const Vec3 axis{x_least ? 1.0F : 0.0F, y_least ? 1.0F : 0.0F, x_least || y_least ? 0.0F : 1.0F};
    left = axis - axis.dot(ahead) * ahead;
  }
  frame.left = left.normalized();
  frame.up = {ahead.y() * frame.left.z() - ahead.z() * frame.left.y(),
              ahead.z() * frame.left.x() - ahead.x() * frame.left.z(),
              ahead.x() * frame.left.y() - ahead.y() * frame.left.x()};
  return frame;
}

void CircleFit::begin(const FitFrame& frame, float max_curvature) {
  frame_ = frame;
  left_.open(max_curvature);
  if (!frame.flat()) up_.open(max_curvature);
  last_ = {0.0F, 0.0F, 0.0F};
  chord_passed_ = 0.0F;
}

/// If the ends of a long chord are within the tolerance, the ends of a shorter chord at the same
/// point are, too. So the check is made for a chord that is slightly longer than the real one. Then
/// the next chord, which often has nearly the same length, needs no further check.
void CircleFit::pass(const Vec3& here, float within_mm) {
  constexpr float kAlike = 1.05F;
  const Vec3 chord = here - last_;
  const float chord_mm = chord.norm();
  if (chord_mm > chord_passed_) keep_near(last_, within_mm, chord_mm);
  keep_near(here, within_mm, 0.0F);
  // Circles leave the start at a slope of at most kSteepest. So if this condition is false, all
  // circles leave the start towards `here`.
  const float beside = std::abs(here.y()) + std::abs(here.z());
  if (here.x() < CircleFan::kSteepest * beside) keep_ahead(here, within_mm);
  chord_passed_ = kAlike * chord_mm;
  keep_near(here, within_mm, chord_passed_);
  last_ = here;
}

void CircleFit::keep_near(const Vec3& point, float within_mm, float chord_mm) {
  const float weight = point.squaredNorm() - square(within_mm) - 0.25F * square(chord_mm);
  left_.pass({point.x(), point.y()}, weight, frame_.left_share * within_mm);
  if (!frame_.flat()) up_.pass({point.x(), point.z()}, weight, frame_.up_share * within_mm);
}

/// Removes the circles that leave the start away from a point that is not within the tolerance of
/// the start. Such a circle passes the point only at the end of nearly a full turn, which the path
/// does not take. In space, each fan has its share of the condition: if a circle satisfies both
/// shares, it satisfies the condition.
void CircleFit::keep_ahead(const Vec3& point, float within_mm) {
  if (point.squaredNorm() <= square(within_mm)) return;
  left_.keep_ahead(square(frame_.left_share) * point.x(), point.y());
  if (!frame_.flat()) up_.keep_ahead(square(frame_.up_share) * point.x(), point.z());
}

std::optional<CircleFit::Ending> CircleFit::ending_at(const Vec3& here) const {
  const float weight = here.squaredNorm();
  const auto left = left_.through({here.x(), here.y()}, weight);
  if (!left) return std::nullopt;
  CircleFan::Through up{};
  if (!frame_.flat()) {
    const auto found = up_.through({here.x(), here.z()}, weight);
    if (!found) return std::nullopt;
    up = *found;
  }
  Ending ending{.best = {left->middle(), up.middle()}};
  if (left->has_straight() && up.has_straight() && here.x() > 0.0F) {
    ending.best = {{0.0F, here.y() / here.x()}, {0.0F, here.z() / here.x()}};
  }
  if (left->has_level() && up.has_level()) {
    ending.smooth = {{2.0F * here.y() / weight, 0.0F}, {2.0F * here.z() / weight, 0.0F}};
  }
  return ending;
}

}  // namespace cnc::path

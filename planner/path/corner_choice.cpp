#include "planner/path/corner_choice.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/block/axes_in_plane.hpp"

namespace cnc::path {
namespace {

/// A limit without effect, in mm and s.
constexpr float kMuch = 1.0e9F;

/// Limits in each direction of a plane, which follow from the limits of its axes.
struct PlaneLimits {
  float rate_mm_s = kMuch;
  float acceleration_mm_s2 = kMuch;
  float jerk_mm_s3 = kMuch;
  /// Longest time in which an axis of the plane reaches its acceleration under its jerk, s.
  float rise_s = 0.0F;
};

PlaneLimits limits_in(const ArcPlane& plane, const motion::Limits& limits) {
  PlaneLimits found;
  for (const motion::AxisInPlane& each : motion::AxesInPlane{plane, 1.0F}) {
    const float acceleration = limits.acceleration_mm_s2[each.axis];
    const float jerk = limits.jerk_mm_s3[each.axis];
    found.rate_mm_s = std::min(found.rate_mm_s, motion::motor_rate(limits, each.axis) / each.size);
    found.acceleration_mm_s2 = std::min(found.acceleration_mm_s2, acceleration / each.size);
    if (jerk <= 0.0F) continue;
    found.jerk_mm_s3 = std::min(found.jerk_mm_s3, jerk / each.size);
    found.rise_s = std::max(found.rise_s, acceleration / jerk);
  }
  return found;
}

/// Returns the factor by which is_stop_sooner() multiplies 2 v / A, the time for braking to a stop
/// and speeding up again; 1 without a limit of jerk.
/// @param rise_s longest time in which an axis reaches its acceleration, s; 0 without jerk limits
/// @param window_s window of time for a move from rest to rest over the shorter side, s
float share_for(float rise_s, float window_s) {
  constexpr float kFall = 1.3F;
  constexpr float kMin = 0.3F;
  if (rise_s <= 0.0F) return 1.0F;
  return std::max(kMin, window_s / (window_s + kFall * rise_s));
}

}  // namespace

bool is_stop_sooner(const Corner& corner,
                    const RoundedCorner& rounded,
                    const motion::Limits& limits) {
  const auto plane = corner.plane();
  if (!plane) return false;
  const PlaneLimits most = limits_in(*plane, limits);
  const float turn = std::abs(corner.turn);
  const float radius = rounded.trim_mm / tangent_of(0.5F * turn);
  float acceleration = most.acceleration_mm_s2;
  float speed = std::sqrt(acceleration * radius);
  float share = 1.0F;
  if (most.rise_s > 0.0F) {
    const float window = bounded_cube_root(0.5F * rounded.shorter_mm / most.jerk_mm_s3);
    share = share_for(most.rise_s, window);
    acceleration = std::min(acceleration, most.jerk_mm_s3 * window);
    speed = std::min(speed, bounded_cube_root(most.jerk_mm_s3 * square(radius)));
  }
  const float feed =
      rounded.feed_mm_s > 0.0F ? std::min(rounded.feed_mm_s, most.rate_mm_s) : most.rate_mm_s;
  if (speed >= feed) return false;
  const float beside = std::max(0.0F, rounded.shorter_mm - rounded.trim_mm);
  const float reached = std::min(feed, std::sqrt(square(speed) + acceleration * beside));
  // All of the following times are divided by 2 v / A.
  const float ratio = 0.5F * acceleration / square(speed);
  const float blend = ratio * radius * turn;
  const float way = std::max(0.0F, 2.0F * ratio * rounded.trim_mm - 0.5F) * speed / reached;
  return blend - way > share;
}

}  // namespace cnc::path

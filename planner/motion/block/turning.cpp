#include "planner/motion/block/turning.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {

float lag_of(float curvature, float acceleration, float window_s) {
  constexpr float kMax = 0.35F;
  constexpr float kShare = 0.28F;
  constexpr float kStraight = 1.0e-6F;
  const float relative = std::max(curvature * acceleration * square(window_s), kStraight);
  return window_s * std::min(kMax, kShare / std::sqrt(std::sqrt(relative)));
}

Turning Turning::of(float curvature, float acceleration) {
  const float ratio = curvature / acceleration;
  return {curvature, ratio, ratio * curvature};
}

float Turning::speed_limit_square(float window_s) const {
  constexpr float kNoLimit = 1.0e12F;
  if (curvature <= 0.0F || window_s <= 0.0F) return kNoLimit;
  const float centripetal = 1.0F / speed_ratio;
  constexpr float kJerkShare = 0.95F;
  constexpr float kCubes = 1.0e25F;  // Greatest argument of cube_root(). The least is 1 / kCubes.
  const float cube = kJerkShare / (window_s * jerk_ratio);
  return std::min(centripetal, square(cube_root(std::clamp(cube, 1.0F / kCubes, kCubes))));
}

float Turning::steepest(float acceleration,
                        float distance,
                        float speed_square,
                        float cap_square,
                        float window_s,
                        float lag_s) const {
  if (curvature <= 0.0F) return acceleration;
  const float most = within_acceleration(acceleration, distance, speed_square);
  const auto within = [&](float steep) {
    const float end_square = std::min(cap_square, speed_square + 2.0F * steep * distance);
    const float met = std::sqrt(end_square) + steep * lag_s;
    return within_jerk(acceleration, std::min(cap_square, square(met)), window_s);
  };
  return steepest_within(most, within);
}

/// Solves α² + (κ / A)² (v² + 2 α A d)² = 1 for α, with d = `distance`, and returns a = α A.
float Turning::within_acceleration(float acceleration, float distance, float speed_square) const {
  const float normal = speed_ratio * speed_square;
  const float left = 1.0F - square(normal);
  if (left <= 0.0F) return 0.0F;
  const float gain = 2.0F * speed_ratio * acceleration * distance;
  const float half = gain * normal;
  const float leading = 1.0F + square(gain);
  return acceleration * left / (half + std::sqrt(square(half) + leading * left));
}

/// Solves (α + r)² + (α q)² = 1 for α, with r = κ² v³ T / A and q = 3 κ v T, and returns a = α A.
/// The terms are jerks relative to A / T.
float Turning::within_jerk(float acceleration, float speed_square, float window_s) const {
  const float speed = std::sqrt(speed_square);
  const float r = jerk_ratio * speed * speed_square * window_s;
  const float q = 3.0F * curvature * speed * window_s;
  const float left = 1.0F - square(r);
  if (left <= 0.0F) return 0.0F;
  return acceleration * left / (r + std::sqrt(square(r) + (1.0F + square(q)) * left));
}

}  // namespace cnc::motion

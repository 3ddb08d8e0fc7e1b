#include "planner/motion/turning.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {

float Turning::speed_limit_square() const {
  constexpr float kNoLimit = 1.0e12F;
  if (curvature <= 0.0F) return kNoLimit;
  const float centripetal = acceleration / curvature;
  if (window_s <= 0.0F) return centripetal;
  constexpr float kJerkShare = 0.8F;
  constexpr float kLeast = 1.0e-25F;  // What a cube root may be asked for.
  const float cube = kJerkShare * acceleration / (window_s * square(curvature));
  return std::min(centripetal, square(cube_root(std::clamp(cube, kLeast, 1.0e25F))));
}

float Turning::steepest(float distance, float speed_square, float cap_square) const {
  if (curvature <= 0.0F) return acceleration;
  const float most = within_acceleration(distance, speed_square);
  if (window_s <= 0.0F) return most;
  return std::min(most, within_jerk(std::min(cap_square, speed_square + 2.0F * most * distance)));
}

/// a² + κ² (v² + 2 a d)² = A², solved for a.
float Turning::within_acceleration(float distance, float speed_square) const {
  const float normal = curvature * speed_square;
  const float left = square(acceleration) - square(normal);
  if (left <= 0.0F) return 0.0F;
  const float gain = 2.0F * curvature * distance;
  const float leading = 1.0F + square(gain);
  const float half = gain * normal;
  return left / (half + std::sqrt(square(half) + leading * left));
}

/// (a p + r)² + (a q)² = J², solved for a.
float Turning::within_jerk(float speed_square) const {
  const float speed = std::sqrt(speed_square);
  const float p = 1.0F / window_s;
  const float q = 3.0F * curvature * speed;
  const float r = square(curvature) * speed * speed_square;
  const float left = square(acceleration * p) - square(r);
  if (left <= 0.0F) return 0.0F;
  const float leading = square(p) + square(q);
  const float half = p * r;
  return left / (half + std::sqrt(square(half) + leading * left));
}

}  // namespace cnc::motion

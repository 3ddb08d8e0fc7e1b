#include "planner/motion/junction.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::motion {
namespace {

/// 2 (1 − |cos β|) of the turn that still counts as none, or as a reversal;
/// Grbl 1.1 draws both lines at |cos β| = 0.999999.
constexpr float kStraight = 2.0e-6F;

}  // namespace

float corner_speed_square(const AxisArray<float>& before,
                          const AxisArray<float>& after,
                          const Limits& limits) {
  // From the difference of the tangents, not from their dot product: near a
  // tangent joint the latter has lost the angle. |after − before|² = 4 sin²(β/2).
  // Near a reversal it is their sum that keeps the digits: 4 cos²(β/2).
  AxisArray<float> change{};
  float change_square = 0.0F;
  float sum_square = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    change[axis] = after[axis] - before[axis];
    change_square += change[axis] * change[axis];
    const float sum = after[axis] + before[axis];
    sum_square += sum * sum;
  }
  if (change_square < kStraight) return kNoCornerLimit;
  if (sum_square < kStraight) return 0.0F;

  const float size = std::sqrt(change_square);
  float acceleration = 1.0e9F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float share = std::abs(change[axis]) / size;
    if (limits.acceleration_mm_s2[axis] < acceleration * share) {
      acceleration = limits.acceleration_mm_s2[axis] / share;
    }
  }
  const float sine_square = 0.25F * change_square;
  const float cosine = 0.5F * std::sqrt(sum_square);
  // 1 − cos = sin² / (1 + cos), without cancellation.
  return acceleration * limits.junction_deviation_mm * cosine * (1.0F + cosine) / sine_square;
}

}  // namespace cnc::motion

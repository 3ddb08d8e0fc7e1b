#include "planner/motion/lookahead/line_limits.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {

LineLimits::LineLimits(const Block& block, const Limits& limits, const TimeWindow& window)
    : acceleration_{block.acceleration}, speed_square_{block.speed_limit_square}, window_{window} {
  if (!window.filters()) return;
  float sum = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float share = std::abs(block.direction[axis]);
    const float limit = planned_acceleration(limits, axis, window);
    sum += square(limit);
    if (limit < acceleration_ * share) acceleration_ = limit / share;
  }
  all_axes_ = std::sqrt(sum);
}

float LineLimits::reach_within(float cap_square, float reachable_square) const {
  // After leaving the block with the speed v, the plan may continue to speed up with A =
  // `all_axes_`. Over a time window T, speeding up adds at most A T² / 12 to the distance.
  const float speeding_up = all_axes_ * square(window_.seconds()) / 12.0F;
  return std::min(window_.reach(cap_square), window_.reach(reachable_square) + speeding_up);
}

}  // namespace cnc::motion

#pragma once

#include <algorithm>

#include "planner/base/axes.hpp"
#include "planner/base/step_position.hpp"
#include "planner/motion/block/power_table.hpp"

namespace cnc::motion {

/// Limits of the machine. For rotary axes, the unit mm means degrees.
struct Limits {
  AxisArray<AxisScale> scale{};
  AxisArray<float> rate_mm_s{};           ///< Greatest speed of each axis, $110…$115.
  AxisArray<float> acceleration_mm_s2{};  ///< Greatest acceleration of each axis, $120…$125.
  AxisArray<float> jerk_mm_s3{};        ///< Greatest jerk of each axis, $800…$805; 0 is no limit.
  float junction_deviation_mm = 0.01F;  ///< Greatest deviation of a blend from its corner, $11.
  float steps_per_s_one_motor = 100'000.0F;
  float steps_per_s_all_motors = 200'000.0F;
  BeamResponse beam{};
};

/// Returns the greatest speed of an axis in mm/s. It is the rate limit of the axis or, if lower,
/// the speed at which the axis's motor reaches its greatest step rate.
[[nodiscard]] inline float motor_rate(const Limits& limits, std::size_t axis) {
  return std::min(limits.rate_mm_s[axis],
                  limits.steps_per_s_one_motor / limits.scale[axis].steps_per_mm());
}

/// Overrides that the operator sets while the job runs, as factors of the programmed values.
struct Overrides {
  float feed = 1.0F;
  float rapid = 1.0F;
  float power = 1.0F;
  constexpr bool operator==(const Overrides&) const = default;
};

}  // namespace cnc::motion

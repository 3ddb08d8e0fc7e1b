#pragma once

#include <cstdint>

#include "planner/base/step_position.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// One axis over one slice: from place to place with a speed at the start.
struct AxisSlice {
  StepPosition from{};
  StepPosition to{};
  float speed_steps_per_tick = 0.0F;  ///< At `from`, signed.
  float ticks = 0.0F;                 ///< Planned duration.
};

/// Steps fall where the planned position crosses half a step, so that the
/// motor is always at the step nearest to the plan. Position is taken as a
/// parabola through `from`, `to` and the start speed.
///
/// Exact for up to three steps; for more, the times of the first, middle and
/// last are exact and the rest on a parabola through them. With slices that
/// change speed by at most half, the error stays below 2 % of the slice.
///
/// @param shift ticks by which the slice starts after its first whole tick.
[[nodiscard]] StepTrain time_steps(const AxisSlice& slice, float shift);

}  // namespace cnc::motion

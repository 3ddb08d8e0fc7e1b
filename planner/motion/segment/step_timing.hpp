#pragma once

#include <cstdint>

#include "planner/base/step_position.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// Motion of one axis over one slice: its start, its end and its speed at the start.
struct AxisSlice {
  StepPosition from{};
  StepPosition to{};
  float speed_steps_per_tick = 0.0F;  ///< Speed at `from`, signed.
  float ticks = 0.0F;                 ///< Planned duration.
};

/// Returns the times of the steps of a slice. A step is due where the planned position crosses half
/// a step, so that the motor is always at the step nearest to the plan. Over time, the position is
/// assumed to follow a parabola through `from` and `to` with the start speed.
///
/// The times of up to three steps are exact. For more steps, the times of the first, the middle and
/// the last step are exact. The times of all other steps are on a parabola through these times. If
/// the speed changes by at most half within the slice, the error stays below 2 % of the slice.
///
/// @param shift time in ticks from the start of the segment to the start of the slice; may be
/// negative
[[nodiscard]] StepTrain time_steps(const AxisSlice& slice, float shift);

}  // namespace cnc::motion

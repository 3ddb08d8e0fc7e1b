#pragma once

#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/base/step_position.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// A slice of the planned motion, from which pulses are made later.
struct PlannedSlice {
  AxisArray<StepPosition> end{};
  std::uint32_t duration_ns = 0;
  float start_duty = 0.0F;  ///< Duty at the start, 0…1; it changes linearly to end_duty.
  float end_duty = 0.0F;
  OutputChanges outputs{};  ///< Changes at the start of the slice.
  SourceLine line{};
};

/// Adds the changes `later` to the changes `pending`, which take effect together. If both change
/// the same output, `later` wins.
inline void merge(OutputChanges& pending, const OutputChanges& later) {
  pending.raise = static_cast<std::uint8_t>((pending.raise & ~later.lower) | later.raise);
  pending.lower = static_cast<std::uint8_t>((pending.lower & ~later.raise) | later.lower);
  if (later.analog_channel == OutputChanges::kNoAnalog) return;
  pending.analog_channel = later.analog_channel;
  pending.analog_value = later.analog_value;
}

}  // namespace cnc::motion

#pragma once

#include "firmware/steps/step_drive.hpp"
#include "firmware/steps/turn_gate.hpp"
#include "planner/motion/motor_segments.hpp"

namespace cnc {

/// Hands segments to the drive until it has enough of them or there are no more, or until there
/// is three times as much as is driven in a turn: planning a start takes no longer than the rest.
inline void feed_segments(StepDrive& drive, motion::Segmenter& plan, motion::MotorStage& motors) {
  constexpr std::uint32_t kTicksInATurn = 3 * kTurnTicks;
  for (std::uint32_t cut = 0; drive.wants_more() && cut < kTicksInATurn;) {
    motion::Segment segment;
    if (!motion::next_segment(plan, motors, segment)) return;
    drive.push(segment);
    cut += segment.ticks;
  }
}

}  // namespace cnc

#pragma once

#include "firmware/steps/step_drive.hpp"
#include "firmware/steps/turn_gate.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// Hands segments to the drive. Stops when the drive has enough segments, when `next` has no more,
/// or when the segments of this call last three cycles. The bound of three cycles limits the
/// planning time of the cycle in which motion starts.
/// @param next makes the next segment; returns false if there is none
template <typename Source>
void feed_segments(StepDrive& drive, Source&& next) {
  constexpr std::uint32_t kTicksInCycle = 3 * kTurnTicks;
  for (std::uint32_t cut = 0; drive.wants_more() && cut < kTicksInCycle;) {
    motion::Segment segment;
    if (!next(segment)) return;
    drive.push(segment);
    cut += segment.ticks;
  }
}

}  // namespace cnc

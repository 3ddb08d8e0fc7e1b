#pragma once

#include "firmware/steps/step_drive.hpp"
#include "planner/motion/motor_segments.hpp"

namespace cnc {

/// Hands segments to the drive until it has enough of them or there are no more.
inline void feed_segments(StepDrive& drive, motion::Segmenter& plan, motion::MotorStage& motors) {
  while (drive.wants_more()) {
    motion::Segment segment;
    if (!motion::next_segment(plan, motors, segment)) return;
    drive.push(segment);
  }
}

}  // namespace cnc

#pragma once

#include "planner/motion/motors/motor_stage.hpp"
#include "planner/motion/segment/segmenter.hpp"

namespace cnc::motion {

/// The next segment of the motors: the plan's own where no shaper and no backlash is set.
/// False when there is none: everything driven to its end, halted and come to rest, or
/// the stage is another segmenter's.
[[nodiscard]] bool next_segment(Segmenter& plan, MotorStage& motors, Segment& segment);

}  // namespace cnc::motion

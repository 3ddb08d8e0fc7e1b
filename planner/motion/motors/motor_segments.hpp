#pragma once

#include "planner/motion/motors/motor_stage.hpp"
#include "planner/motion/segment/segmenter.hpp"

namespace cnc::motion {

/// Makes the next segment of the motors. It is the plan's own where no shaper and no backlash is
/// set and slices do not leave the path. Returns false if there is none: everything is driven to
/// its end, the motion is halted and has come to rest, or another segmenter owns the stage.
[[nodiscard]] bool next_segment(Segmenter& plan, MotorStage& motors, Segment& segment);

}  // namespace cnc::motion

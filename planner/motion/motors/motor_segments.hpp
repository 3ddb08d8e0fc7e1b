#pragma once

#include "planner/motion/motors/motor_stage.hpp"
#include "planner/motion/segment/segmenter.hpp"

namespace cnc::motion {

/// Makes the next segment of the motors. If no shaper and no backlash is set and slices stay on the
/// path, it is the segment of the plan. Returns false if there is no segment: all blocks are driven
/// to their ends, the motion is halted and has come to rest, or another segmenter owns the stage.
[[nodiscard]] bool next_segment(Segmenter& plan, MotorStage& motors, Segment& segment);

}  // namespace cnc::motion

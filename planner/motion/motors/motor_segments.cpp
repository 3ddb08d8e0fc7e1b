#include "planner/motion/motors/motor_segments.hpp"

namespace cnc::motion {
namespace {

/// Fills the present cell of the stage. Returns false if the plan and the motors are both at rest.
/// The loop is bounded, because a slice either fills a part of the cell or, if it takes no time,
/// ends a block.
bool fill_motor_cell(Segmenter& plan, MotorStage& motors) {
  while (motors.room_ns() > 0) {
    PlannedSlice slice;
    if (plan.next(motors.room_ns(), slice)) {
      motors.add(slice, &plan);
    } else if (!motors.at_rest()) {
      motors.rest();
    } else {
      return false;
    }
  }
  return true;
}

}  // namespace

bool next_segment(Segmenter& plan, MotorStage& motors, Segment& segment) {
  if (!motors.active() && !plan.leaves_path()) return plan.next(segment);
  if (!motors.at_rest() && motors.owner() != &plan) return false;
  if (motors.take(segment)) return true;
  if (!fill_motor_cell(plan, motors)) return false;
  motors.close_cell();
  return motors.take(segment);
}

}  // namespace cnc::motion

#include "firmware/machine/motion_control.hpp"

namespace cnc {

Result<bool, motion::MotionError> MotionControl::append(const motion::MotionRequest& request) {
  const auto block = motion::build_block(request, limits_);
  if (!block.ok()) {
    if (block.error() != motion::MotionError::kNothingToMove) return block.error();
    return false;
  }
  queue_.push(block.value(), limits_);
  target_ = request.element.end;
  ++blocks_taken_;
  return true;
}

void MotionControl::feed_drive() {
  motion::Segment segment;
  while (!drive_.full() && drive_.ticks_waiting() < drive_.ticks_ahead() &&
         segmenter_.next(segment)) {
    drive_.push(segment);
  }
}

void MotionControl::drop_rest() {
  const AxisArray<std::int32_t> steps = drive_.position();
  target_ = place_of(steps);
  AxisArray<StepPosition> place{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    place[axis] = StepPosition::whole(steps[axis]);
  }
  segmenter_.reset(place);
}

Position MotionControl::place_of(const AxisArray<std::int32_t>& steps) const {
  Position place;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    place[axis] = limits_.scale[axis].place_of(steps[axis]);
  }
  return place;
}

}  // namespace cnc

#include "firmware/machine/motion_control.hpp"

#include "firmware/machine/feed_segments.hpp"

namespace cnc {

bool MotionControl::has_room() const { return !drive_.catches_up() && Pipeline::has_room(); }

void MotionControl::feed_drive() {
  follow_tool();
  feed_segments(drive_, [this](motion::Segment& segment) {
    note_place();
    const bool more = next(segment);
    lit_ = more && !segment.dark();
    return more;
  });
}

/// Stores the distance that the motion has travelled, together with the tick at which it is output.
/// The motor stage outputs a cell with a delay of ticks_ahead(), which is added to the tick.
void MotionControl::note_place() {
  const std::uint32_t tick = drive_.ticks_handed_over();
  if (lit_) trail_.note_light(tick);
  lit_ = false;
  const bool staged = motors().active() || leaves_path();
  if (staged && !motors().between_cells()) return;
  trail_.add(tick + motors().ticks_ahead(), travelled());
}

motion::PathUnits MotionControl::go_back(motion::PathUnits distance) {
  const motion::PathUnits unknown = Pipeline::go_back(distance);
  trail_.begin(drive_.ticks_handed_over(), travelled());
  return unknown;
}

AxisArray<std::int32_t> MotionControl::axis_steps() const {
  AxisArray<std::int32_t> steps = drive_.position();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    steps[axis] = motors().backlash(axis).moved_by(steps[axis], axes_[axis]);
  }
  return steps;
}

Position MotionControl::tool_place() const {
  const Position axes = place_of(axis_steps());
  return tool_centre().active() ? tool_centre().program_for(axes) : axes;
}

AxisArray<std::int32_t> MotionControl::tool_steps() const {
  if (!tool_centre().active()) return axis_steps();
  const AxisArray<StepPosition> place = steps_of(tool_place());
  AxisArray<std::int32_t> steps{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) steps[axis] = place[axis].nearest_step();
  return steps;
}

void MotionControl::set_tool_centre(const kinematics::ToolCentre& centre) {
  Pipeline::set_tool_centre(centre);
  drop_rest();
}

/// Updates the position of the axes from the step counts of the motors. On an axis with backlash,
/// this position may be wrong if the axis reversed between two calls. At rest, the position is
/// corrected by the known offset of the motor from the axis.
void MotionControl::follow_tool() {
  axes_ = axis_steps();
  if (drive_.running() || !motors().at_rest() || !motors().settled()) return;
  const AxisArray<std::int32_t> steps = drive_.position();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    axes_[axis] = tool_at_contact(axis, steps[axis]);
  }
}

void MotionControl::set_tool(std::size_t axis, std::int32_t steps) {
  drive_.set_position(axis, steps);
  motors().rebase(axis);
  axes_[axis] = steps;
}

void MotionControl::configure(const motion::MotorStageSetting& setting) {
  const AxisArray<std::int32_t> steps = axis_steps();
  if (!Pipeline::configure(setting)) return;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) drive_.set_position(axis, steps[axis]);
  axes_ = steps;
}

void MotionControl::drop_rest() {
  follow_tool();
  restart(axes_, drive_.position());
}

}  // namespace cnc

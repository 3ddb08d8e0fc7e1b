#include "planner/motion/motors/motor_stage.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"
#include "planner/base/truncate.hpp"
#include "planner/motion/segment/power_course.hpp"
#include "planner/motion/segment/step_timing.hpp"

namespace cnc::motion {
namespace {

constexpr float kQ16 = 65'536.0F;

float to_steps(StepPosition from, StepPosition to) {
  return static_cast<float>(to.q32() - from.q32()) * StepPosition::kStepsPerUnit;
}

}  // namespace

void MotorStage::configure(const MotorStageSetting& setting) {
  CNC_ASSERT(at_rest());
  setting_ = setting;
  grid_ = grid_of(setting.shapers);
  active_ = grid_.shapes;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    backlash_[axis].configure(setting.backlash[axis]);
    active_ = active_ || backlash_[axis].active();
  }
}

void MotorStage::reset(const Places& tool, const Steps& ahead) {
  at_rest_ = true;
  owner_ = nullptr;
  used_ns_ = 0;
  rests_ = true;
  cells_at_rest_ = 0;
  tool_ = tool;
  history_.fill(tool);
  comes_to_rest_ = false;
  out_tick_ = grid_.cell_ticks;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    backlash_[axis].stand(tool[axis], ahead[axis]);
    const std::int64_t motor = tool[axis].q32() + StepPosition::whole(ahead[axis]).q32();
    motors_[axis] = StepPosition{motor};
    courses_[axis] = {.from = motors_[axis], .to = motors_[axis]};
  }
}

bool MotorStage::settled() const {
  return std::all_of(backlash_.begin(), backlash_.end(), [](const Backlash& backlash) {
    return backlash.settled();
  });
}

std::uint32_t MotorStage::cell_ns() const { return grid_.cell_ticks * kNsPerTick; }

float MotorStage::cell_seconds() const {
  return static_cast<float>(grid_.cell_ticks) / static_cast<float>(kTicksPerSecond);
}

/// Begins a motion. Fills the first cells with the output at rest, because the motion is output
/// only after the delay of the shapers.
void MotorStage::begin(const PlannedSlice& slice, const void* owner) {
  at_rest_ = false;
  owner_ = owner;
  rest_duty_ = setting_.dark_at_rest ? 0.0F : slice.start_duty;
  outputs_.clear(grid_.ahead + 2);
  lines_.begin(slice.line, grid_.ahead + 2);
  line_ = slice.line;
  for (std::uint32_t cell = 0; cell < grid_.ahead; ++cell) {
    outputs_.hold(rest_duty_, grid_.cell_ticks);
    outputs_.close_cell();
  }
}

void MotorStage::add(const PlannedSlice& slice, const void* owner) {
  CNC_ASSERT(slice.duration_ns <= room_ns());
  if (at_rest_) begin(slice, owner);
  CNC_ASSERT(owner_ == owner);
  rests_ = false;
  tool_ = slice.end;
  line_ = slice.line;
  used_ns_ += slice.duration_ns;
  if (!setting_.dark_at_rest) rest_duty_ = slice.end_duty;
  outputs_.add(slice, (used_ns_ + kNsPerTick / 2) / kNsPerTick);
}

void MotorStage::rest() {
  used_ns_ = cell_ns();
  outputs_.hold(rest_duty_, grid_.cell_ticks);
}

void MotorStage::close_cell() {
  CNC_ASSERT(room_ns() == 0 && out_tick_ == grid_.cell_ticks);
  history_.push(tool_);
  outputs_.close_cell();
  lines_.add(line_);
  cells_at_rest_ = rests_ ? cells_at_rest_ + 1 : 0;
  used_ns_ = 0;
  rests_ = true;
  out_tick_ = 0;
  comes_to_rest_ = cells_at_rest_ >= std::max<std::uint32_t>(1, grid_.reach());
  Places shaped{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    shaped[axis] = history_.mean(axis, grid_.taps[axis]);
    lay_course(axis, shaped[axis]);
  }
  if (observer_ != nullptr) observer_->on_cell({tool_, shaped, grid_.reach(), cell_ns()});
  comes_to_rest_ = comes_to_rest_ && settled();
}

/// Computes the motion of a motor in the cell that is being output. The start speed is limited so
/// that the motor does not reverse within the cell, and so that the speed at the end of the cell
/// does not exceed the greatest speed of the motor.
void MotorStage::lay_course(std::size_t axis, StepPosition tool) {
  Course& course = courses_[axis];
  const float before = course.way;
  const std::int64_t offset = backlash_[axis].follow(tool, cell_seconds());
  course.from = course.to;
  course.to = StepPosition{tool.q32() + offset};
  course.way = to_steps(course.from, course.to);
  const float most = setting_.max_steps_per_s[axis] * cell_seconds();
  const float side = course.way < 0.0F ? -1.0F : 1.0F;
  const float way = side * course.way;
  const float mean = 0.5F * (side * before + way);
  course.lead =
      side * std::clamp(mean, std::max(0.0F, 2.0F * way - std::max(most, way)), 2.0F * way);
}

StepPosition MotorStage::place_at(const Course& course, std::uint32_t tick) const {
  if (tick == grid_.cell_ticks) return course.to;
  const float x = static_cast<float>(tick) / static_cast<float>(grid_.cell_ticks);
  const float way = x * (course.lead + x * (course.way - course.lead));
  return StepPosition{course.from.q32() + truncated(way * kQ16) * 65'536};
}

bool MotorStage::take(Segment& segment) {
  if (out_tick_ == grid_.cell_ticks) return false;
  const OutputPiece piece = outputs_.take();
  const std::uint32_t end_tick = out_tick_ + piece.ticks;
  constexpr float kDuty = 1.0F / kFullOutput;
  segment = {};
  segment.ticks = piece.ticks;
  segment.outputs = piece.outputs;
  segment.line = lines_.line();
  segment.power = power_course(
      static_cast<float>(piece.start) * kDuty, static_cast<float>(piece.end) * kDuty, piece.ticks);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) time_train(axis, end_tick, segment);
  out_tick_ = end_tick;
  if (!comes_to_rest_ || end_tick < grid_.cell_ticks) return true;
  segment.comes_to_rest = true;
  at_rest_ = true;
  owner_ = nullptr;
  return true;
}

void MotorStage::time_train(std::size_t axis, std::uint32_t end_tick, Segment& segment) {
  const Course& course = courses_[axis];
  if (course.from == course.to) return;
  const StepPosition to = place_at(course, end_tick);
  const auto cell = static_cast<float>(grid_.cell_ticks);
  const float x = static_cast<float>(out_tick_) / cell;
  const AxisSlice slice{
      .from = motors_[axis],
      .to = to,
      .speed_steps_per_tick = (course.lead + 2.0F * x * (course.way - course.lead)) / cell,
      .ticks = static_cast<float>(segment.ticks)};
  segment.trains[axis] = time_steps(slice, 0.0F);
  if (to.q32() < motors_[axis].q32()) {
    segment.negative = static_cast<std::uint8_t>(segment.negative | (1U << axis));
  }
  motors_[axis] = to;
}

}  // namespace cnc::motion

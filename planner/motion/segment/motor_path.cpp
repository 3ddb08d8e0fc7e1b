#include "planner/motion/segment/motor_path.hpp"

#include "planner/base/truncate.hpp"

namespace cnc::motion {
namespace {

constexpr std::uint64_t kWhole = std::uint64_t{1} << 32;

}  // namespace

void MotorPath::Motor::turn(std::int64_t normal, float per_mm) {
  normal_ = Length{normal};
  normal_per_mm_ = nearest_float(normal) * per_mm;
  turns_ = true;
}

void MotorPath::begin(const Block& block, const AxisArray<StepPosition>& start) {
  frame_ = ChordFrame{block.turn.half_sweep};
  turns_ = block.turns();
  count_ = 0;
  const float per_mm = StepPosition::kStepsPerUnit / block.length;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const std::int64_t chord = block.end[axis].q32() - start[axis].q32();
    const bool turns = turns_ && block.turn.plane.has(axis);
    if (chord == 0 && !turns) continue;
    Motor& motor = motors_[count_++];
    motor = Motor{axis, start[axis], chord, per_mm};
    if (turns) motor.turn(block.normal[axis].q32(), per_mm);
  }
}

MotorPath::Point MotorPath::at(std::uint64_t fraction) const {
  const bool at_end = fraction >= kWhole;
  const auto within = at_end ? ~std::uint32_t{0} : static_cast<std::uint32_t>(fraction);
  Point point{.fraction = within, .at_end = at_end};
  if (turns_) point.turn = frame_.at(within);
  return point;
}

}  // namespace cnc::motion

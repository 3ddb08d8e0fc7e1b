#include "planner/motion/block_rest.hpp"

#include "planner/motion/motor_path.hpp"

namespace cnc::motion {
namespace {

constexpr float kQ16 = 65'536.0F;
constexpr float kFractionUnit = 1.0F / 4294967296.0F;

/// Returns a length on one motor's scale on another's.
StepPosition on_scale(std::int64_t steps_q32, const AxisScale& from, const AxisScale& to) {
  if (from.steps_per_mm() == to.steps_per_mm()) return StepPosition{steps_q32};
  const float steps = nearest_float(steps_q32) * StepPosition::kStepsPerUnit;
  const float scaled = steps * (to.steps_per_mm() / from.steps_per_mm());
  return StepPosition{truncated(scaled * kQ16) * 65'536};
}

/// Turns the chord from `start` to the end of the block by a quarter turn, as the builder does.
void turn_chord(Block& block, const AxisArray<StepPosition>& start, const Limits& limits) {
  const PlaneAxes axes = axes_of(block.turn.plane);
  const AxisScale& first = limits.scale[axes.first];
  const AxisScale& second = limits.scale[axes.second];
  const std::int64_t along_first = block.end[axes.first].q32() - start[axes.first].q32();
  const std::int64_t along_second = block.end[axes.second].q32() - start[axes.second].q32();
  block.normal = {on_scale(-along_second, second, first), on_scale(along_first, first, second)};
}

}  // namespace

BlockRest rest_of(const Block& block,
                  const AxisArray<StepPosition>& start,
                  PathUnits place,
                  const Limits& limits) {
  BlockRest rest{.block = block, .start = start};
  rest.block.from_rest = true;
  if (place <= 0) return rest;
  const PathUnits length = length_in_units(block);
  const std::uint64_t fraction = BlockFraction{length}.of(place);
  const MotorPath path{block, start};
  const MotorPath::Point point = path.at(fraction);
  for (const MotorPath::Motor& motor : path.moving()) {
    rest.start[motor.axis()] = motor.place(point);
  }
  const float share = nearest_float(fraction) * kFractionUnit;
  rest.block.outputs = {};
  rest.block.length = to_mm(length - place);
  rest.block.row = block.row.part(share, 1.0F);
  if (!block.turns()) return rest;
  rest.block.turn.start_angle += 2.0F * block.turn.half_sweep * share;
  rest.block.turn.half_sweep *= to_mm(length - place) / to_mm(length);
  turn_chord(rest.block, rest.start, limits);
  return rest;
}

}  // namespace cnc::motion

#include "planner/motion/block_rest.hpp"

#include "planner/motion/motor_path.hpp"

namespace cnc::motion {
namespace {

/// The chord from `start` to the end of the block in `axis`, in mm.
float chord_mm(const Block& block,
               const AxisArray<StepPosition>& start,
               std::size_t axis,
               const Limits& limits) {
  const std::int64_t steps_q32 = block.end[axis].q32() - start[axis].q32();
  const float steps = nearest_float(steps_q32) * StepPosition::kStepsPerUnit;
  return steps / limits.scale[axis].steps_per_mm();
}

}  // namespace

BlockRest rest_of(const Block& block,
                  const AxisArray<StepPosition>& start,
                  PathUnits place,
                  const Limits& limits) {
  BlockRest rest{.block = block, .start = start};
  if (place <= 0) return rest;
  const PathUnits length = length_in_units(block);
  const MotorPath path{block, start};
  const MotorPath::Point point = path.at(BlockFraction{length}.of(place));
  for (const MotorPath::Motor& motor : path.moving()) {
    rest.start[motor.axis()] = motor.place(point);
  }
  const float whole_mm = to_mm(length);
  const float share = to_mm(place) / whole_mm;
  Turn& turn = rest.block.turn;
  turn.start_angle += 2.0F * turn.half_sweep * share;
  rest.block.length = to_mm(length - place);
  turn.half_sweep *= rest.block.length / whole_mm;
  rest.block.outputs = {};
  rest.block.row = block.row.part(share, 1.0F);
  // The chord is turned as the builder does.
  const PlaneAxes axes = axes_of(turn.plane);
  const float first = chord_mm(block, rest.start, axes.first, limits);
  const float second = chord_mm(block, rest.start, axes.second, limits);
  const auto along_first = limits.scale[axes.first].steps_at(from_mm(-second));
  const auto along_second = limits.scale[axes.second].steps_at(from_mm(first));
  if (along_first && along_second) rest.block.normal = {*along_first, *along_second};
  return rest;
}

}  // namespace cnc::motion

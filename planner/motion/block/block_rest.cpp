#include "planner/motion/block/block_rest.hpp"

namespace cnc::motion {
namespace {

/// Sets `normal` of the block to the chord from `start` to the end of the block, turned to the left
/// by a quarter turn as in build_block().
void turn_chord(Block& block, const AxisArray<StepPosition>& start, const Limits& limits) {
  AxisVector chord{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const std::int64_t steps_q32 = block.end[axis].q32() - start[axis].q32();
    const float steps = nearest_float(steps_q32) * StepPosition::kStepsPerUnit;
    chord[axis] = steps / limits.scale[axis].steps_per_mm();
  }
  const ArcPlane& plane = block.turn.plane;
  const AxisVector normal = plane.vector(left_normal(plane.seen(chord)));
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const AxisScale& scale = limits.scale[axis];
    const auto turned =
        plane.oblique() ? scale.steps_of(normal[axis]) : scale.steps_at(from_mm(normal[axis]));
    if (turned) block.normal[axis] = *turned;
  }
}

}  // namespace

Block rest_of(const Block& block,
              const AxisArray<StepPosition>& start,
              PathUnits place,
              const Limits& limits) {
  Block rest = block;
  if (place <= 0) return rest;
  const PathUnits length = length_in_units(block);
  const float whole_mm = to_mm(length);
  const float share = to_mm(place) / whole_mm;
  rest.turn.start_angle += 2.0F * rest.turn.half_sweep * share;
  rest.length = to_mm(length - place);
  rest.turn.half_sweep *= rest.length / whole_mm;
  rest.outputs = {};
  rest.row = rest.row.part(share, 1.0F);
  turn_chord(rest, start, limits);
  return rest;
}

}  // namespace cnc::motion

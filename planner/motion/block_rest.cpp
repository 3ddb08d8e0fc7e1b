#include "planner/motion/block_rest.hpp"

#include <array>
#include <utility>

namespace cnc::motion {
namespace {

/// Turns the chord from `start` to the end of the block by a quarter turn, as the builder does.
void turn_chord(Block& block, const AxisArray<StepPosition>& start, const Limits& limits) {
  const PlaneAxes axes = axes_of(block.turn.plane);
  std::array<std::size_t, 2> along{axes.first, axes.second};
  float side = -1.0F;
  for (StepPosition& normal : block.normal) {
    const std::int64_t steps_q32 = block.end[along[1]].q32() - start[along[1]].q32();
    const float steps = nearest_float(steps_q32) * StepPosition::kStepsPerUnit;
    const AxisScale& scale = limits.scale[along[1]];
    const auto turned =
        limits.scale[along[0]].steps_at(from_mm(side * steps / scale.steps_per_mm()));
    if (turned) normal = *turned;
    std::swap(along[0], along[1]);
    side = 1.0F;
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

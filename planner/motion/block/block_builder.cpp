#include "planner/motion/block/block_builder.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc.hpp"

namespace cnc::motion {
namespace {

/// Returns the length of the X Y Z part of a vector.
float linear_norm(const AxisVector& vector) {
  float sum = 0.0F;
  for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) sum += square(vector[axis]);
  return std::sqrt(sum);
}

/// Sets the end of the block in steps. Returns false if the end is outside the range of the step
/// counters.
bool place_in_steps(const PathElement& element, const Limits& limits, Block& block) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto end = limits.scale[axis].steps_at(element.end[axis]);
    if (!end) return false;
    block.end[axis] = *end;
  }
  return true;
}

/// Sets `normal` of a block in an oblique plane: the chord, turned to the left by a quarter turn.
/// Returns false if the normal is outside the range of the step counters.
bool place_oblique_normal(const AxisVector& chord, const Limits& limits, Block& block) {
  const ArcPlane& plane = block.turn.plane;
  const AxisVector normal = plane.vector(left_normal(plane.seen(chord)));
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto along = limits.scale[axis].steps_of(normal[axis]);
    if (!along) return false;
    block.normal[axis] = *along;
  }
  return true;
}

/// Sets `normal` of the block, in steps: the chord, turned to the left by a quarter turn. The chord
/// (first, second) becomes (−second, first). Each component is converted with the scale of the axis
/// that it belongs to after the turn. Returns false if the normal is outside the range of the step
/// counters.
bool place_normal(const PathElement& element, const Limits& limits, Block& block) {
  if (element.plane.oblique()) {
    return place_oblique_normal(travel_between(element.start, element.end), limits, block);
  }
  const PlaneAxes axes = axes_of(element.plane);
  const Coordinate first = element.end[axes.first] - element.start[axes.first];
  const Coordinate second = element.end[axes.second] - element.start[axes.second];
  const auto along_first = limits.scale[axes.first].steps_at(-second);
  const auto along_second = limits.scale[axes.second].steps_at(first);
  if (!along_first || !along_second) return false;
  block.normal[axes.first] = *along_first;
  block.normal[axes.second] = *along_second;
  return true;
}

/// Fills `turn` from the arc, and returns the length of the arc in mm. Removes from `travel` the
/// part in the plane of the arc, because the arc replaces that part.
float lay_out_turn(const Arc& arc, AxisVector& travel, Turn& turn) {
  travel = turn.plane.oblique() ? AxisVector{} : turn.plane.off(travel);
  const Vec2 tangent = arc.start_tangent();
  turn.half_sweep = arc.half_sweep();
  turn.start_angle = atan2_f(tangent.y(), tangent.x());
  turn.curvature = std::abs(arc.curvature());
  return arc.length().in_mm_and_s();
}

/// Returns whether the sagitta of an arc is more than 1e-6 nm. A flatter arc is driven as a line,
/// because its sweep and curvature would be outside the range of a float.
bool leaves_its_chord(float bulge, const Arc& arc) {
  constexpr float kMinSagitta = 1.0e-12F;  // mm
  return std::abs(bulge) * arc.end().norm() > 2.0F * kMinSagitta;
}

/// Returns the limit of v² for the whole block. It follows from the rates of the axes outside the
/// plane of an arc (on a line, of all axes), and from the step rate of all motors together.
float speed_limit_square(const Block& block, const Limits& limits) {
  float limit = 1.0e12F;
  float steps_per_mm = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float share = std::abs(block.direction[axis]);
    steps_per_mm += share * limits.scale[axis].steps_per_mm();
    const float rate = motor_rate(limits, axis);
    if (square(rate) < limit * square(share)) limit = square(rate / share);
  }
  if (block.turns()) {
    float sum = 0.0F;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (block.turn.plane.has(axis)) sum += square(limits.scale[axis].steps_per_mm());
    }
    steps_per_mm += block.turn.plane_share * std::sqrt(sum);
  }
  return std::min(limit, square(limits.steps_per_s_all_motors / steps_per_mm));
}

/// Returns the greatest acceleration along the path, in mm/s², that the axes outside the plane of
/// an arc allow (on a line, all axes).
float acceleration_limit(const Block& block, const Limits& limits) {
  float most = 1.0e9F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float share = std::abs(block.direction[axis]);
    const float limit = limits.acceleration_mm_s2[axis];
    if (limit < most * share) most = limit / share;
  }
  return most;
}

/// Converts a programmed feed to the speed along all six axes, which the planner uses. The F word
/// gives the speed along X Y Z, or along A B C if only these axes move.
float six_axis_feed(float feed, float linear_length, float length) {
  return linear_length > 0.0F ? feed * (length / linear_length) : feed;
}

/// Returns the ratio of an arc's length along X Y Z to its length along all axes of its plane. In
/// an oblique plane, in which rotary axes may move, returns this ratio for the chord instead.
float linear_share(const ArcPlane& plane, const AxisVector& chord) {
  return plane.oblique() ? linear_norm(chord) / norm(chord) : 1.0F;
}

}  // namespace

Result<Block, MotionError> build_block(const MotionRequest& request, const Limits& limits) {
  const PathElement& element = request.element;
  Block block;
  block.beam = request.beam;
  block.row = request.row;
  block.outputs = request.outputs;
  block.line = request.line;
  block.fixed_feed = request.fixed_feed;
  if (!place_in_steps(element, limits, block)) return MotionError::kBeyondMotorRange;

  AxisVector travel = travel_between(element.start, element.end);
  block.turn.plane = element.plane.holding(travel);
  float plane_length = 0.0F;
  float linear_in_plane = 0.0F;
  const auto arc = Arc::make(Vec2{0.0F, 0.0F}, block.turn.plane.seen(travel), element.bulge);
  if (!arc.ok() && arc.error() == ArcError::kSweepTooLarge) return MotionError::kBulgeTooLarge;
  if (arc.ok() && leaves_its_chord(element.bulge, arc.value())) {
    if (!place_normal(element, limits, block)) return MotionError::kBeyondMotorRange;
    const float share = linear_share(block.turn.plane, travel);
    plane_length = lay_out_turn(arc.value(), travel, block.turn);
    linear_in_plane = plane_length * share;
  }

  const float straight = norm(travel);
  const float linear = linear_norm(travel);
  block.length = std::sqrt(square(straight) + square(plane_length));
  if (block.length <= 0.0F) return MotionError::kNothingToMove;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    block.direction[axis] = travel[axis] / block.length;
  }
  block.turn.plane_share = plane_length / block.length;
  block.acceleration = acceleration_limit(block, limits);
  block.speed_limit_square = speed_limit_square(block, limits);
  block.feed = six_axis_feed(
      request.feed_mm_s, std::sqrt(square(linear) + square(linear_in_plane)), block.length);
  return block;
}

namespace {

AxisArray<float> tangent_at(const Block& block, float angle) {
  if (!block.turns()) return block.direction;
  const SinCos turned = sin_cos(angle);
  const AxisVector in_plane = block.turn.plane.vector({turned.cosine, turned.sine});
  return sum_of(block.direction, block.turn.plane_share, in_plane);
}

}  // namespace

AxisArray<float> entry_tangent(const Block& block) {
  return tangent_at(block, block.turn.start_angle);
}

AxisArray<float> exit_tangent(const Block& block) {
  return tangent_at(block, block.turn.start_angle + 2.0F * block.turn.half_sweep);
}

}  // namespace cnc::motion

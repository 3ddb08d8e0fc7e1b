#include "planner/motion/segment/kerf_shift.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/base/truncate.hpp"
#include "planner/motion/block/block_builder.hpp"

namespace cnc::motion {
namespace {

using Vector = std::array<float, 2>;

/// Returns the two components of a tangent in `plane`. A block next to an edge lies in this plane.
Vector in_plane(const AxisArray<float>& tangent, Plane plane) {
  const PlaneAxes axes = axes_of(plane);
  return {tangent[axes.first], tangent[axes.second]};
}

/// Returns 1 if the beam is to the left of an edge, −1 if it is to the right, and 0 without an
/// edge.
float side_of(Beside beside) {
  if (beside == Beside::kNothing) return 0.0F;
  return beside == Beside::kLeft ? 1.0F : -1.0F;
}

/// Returns the unit vector from the edge to the beam.
Vector off_edge(const Vector& tangent, Beside beside) {
  return {-side_of(beside) * tangent[1], side_of(beside) * tangent[0]};
}

float dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }

/// Returns the vector from a corner to the point where the straight paths before and after it meet
/// if each is shifted by its unit normal. The length is limited to four times the shift, because at
/// a very sharp corner that point is far away.
/// @param before, after unit normals of the two paths
Vector meeting(const Vector& before, const Vector& after) {
  constexpr float kMinShare = 0.125F;
  const float share = std::max(kMinShare, 1.0F + dot(before, after));
  return {(before[0] + after[0]) / share, (before[1] + after[1]) / share};
}

/// Returns the components of a vector along a tangent and along the normal to its left.
Vector seen_from(const Vector& vector, const SinCos& tangent) {
  return {vector[0] * tangent.cosine + vector[1] * tangent.sine,
          vector[1] * tangent.cosine - vector[0] * tangent.sine};
}

}  // namespace

void KerfShift::reset() {
  now_ = end_ = {};
  aside_ = 0.0F;
  steps_q32_ = {};
}

/// Sets plane_ to the plane of a block that is next to an edge. The plane of an oblique arc is not
/// used, because such an arc only joins blocks of one plane to blocks of another.
void KerfShift::take_plane(const Block& block, Beside beside) {
  const ArcPlane& plane = block.turn.plane;
  if (beside != Beside::kNothing && !plane.oblique()) plane_ = plane.coordinate_plane();
}

/// Returns the present vector as components along the two axes of the plane.
KerfShift::Vector KerfShift::vector() const {
  return {now_[0] * tangent_.cosine - now_[1] * tangent_.sine,
          now_[0] * tangent_.sine + now_[1] * tangent_.cosine};
}

void KerfShift::begin(const Block& block) {
  const Vector before = vector();
  beside_ = block.beam.beside;
  take_plane(block, beside_);
  ends_ = true;
  fraction_ = 0.0F;
  turns_ = block.turns() && block.turn.plane == ArcPlane{plane_};
  const Vector entry = in_plane(entry_tangent(block), plane_);
  exit_ = in_plane(exit_tangent(block), plane_);
  start_angle_ = turns_ ? block.turn.start_angle : atan2_f(entry[1], entry[0]);
  sweep_ = turns_ ? 2.0F * block.turn.half_sweep : 0.0F;
  tangent_ = sin_cos(start_angle_);
  now_ = seen_from(before, tangent_);
  end_ = {0.0F, side_of(beside_)};
}

void KerfShift::meet(const Block& next) {
  ends_ = false;
  if (next.beam.beside == Beside::kNothing) return;
  if (beside_ == Beside::kNothing) take_plane(next, next.beam.beside);
  const Vector after = off_edge(in_plane(entry_tangent(next), plane_), next.beam.beside);
  const bool leads = beside_ == Beside::kNothing;
  const Vector there = leads ? after : meeting(off_edge(exit_, beside_), after);
  end_ = seen_from(there, sin_cos(start_angle_ + sweep_));
}

/// Returns `from`, moved towards `to` by `share` of the difference, but by at most `most`.
float KerfShift::approach(float from, float to, float share, float most) {
  return from + std::clamp(share * (to - from), -most, most);
}

void KerfShift::move(float fraction, float way_mm, float heat, const Limits& limits) {
  constexpr float kQ16 = 65'536.0F;
  constexpr float kSteepest = 0.25F;
  constexpr float kNoShift = 1.0e-6F;  // mm
  const float most = kSteepest * way_mm;
  aside_ = approach(aside_, course_->aside_mm(heat), 1.0F, most);
  const float left = 1.0F - fraction_;
  const float share = left > 0.0F ? std::min(1.0F, (fraction - fraction_) / left) : 1.0F;
  fraction_ = fraction;
  const float turn = most / std::max(std::abs(aside_), kNoShift);
  now_[0] = approach(now_[0], end_[0], share, turn);
  now_[1] = approach(now_[1], end_[1], beside_ == Beside::kNothing ? share : 1.0F, turn);
  if (turns_) tangent_ = sin_cos(start_angle_ + fraction * sweep_);
  const Vector shift = vector();
  const PlaneAxes axes = axes_of(plane_);
  const std::array<std::size_t, 2> of{axes.first, axes.second};
  for (std::size_t i = 0; i < shift.size(); ++i) {
    const float steps = aside_ * shift[i] * limits.scale[of[i]].steps_per_mm();
    steps_q32_[i] = std::int64_t{truncated(steps * kQ16)} * 65'536;
  }
}

void KerfShift::add_to(AxisArray<StepPosition>& place) const {
  const PlaneAxes axes = axes_of(plane_);
  place[axes.first] = StepPosition{place[axes.first].q32() + steps_q32_[0]};
  place[axes.second] = StepPosition{place[axes.second].q32() + steps_q32_[1]};
}

}  // namespace cnc::motion

#include "planner/motion/segment/reversals.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {
namespace {

/// Greatest distance, in quarter turns, from an end of the block at which a reversal counts as
/// being at that end. Over this distance, the axis moves by R · 1e-10 on an arc of radius R.
constexpr float kSliverQuarters = 1.0e-5F;

/// Greatest distance from a reversal, in quarter turns, that counts as near. It is a little more
/// than a span of the plan's grid. So a slice that begins at the boundary of a span next to a
/// reversal counts as near, too.
constexpr float kNearQuarters = 1.01F / 24.0F;

}  // namespace

Reversals::Reversals(const Block& block, PathUnits length)
    : length_{length}, next_{length}, near_from_{length} {
  if (!block.turns()) return;
  const float side = block.turn.half_sweep < 0.0F ? -1.0F : 1.0F;
  for (const AxisInPlane& axis : AxesInPlane{block.turn.plane, side}) {
    turns_[turn_count_++] = axis.quarters() + 1.0F;
  }
  start_ = side * block.turn.start_angle / kHalfPi;
  sweep_ = 2.0F * std::abs(block.turn.half_sweep) / kHalfPi;
  look_on_from(0);
}

PathUnits Reversals::place_of(float quarters) const {
  const float share = std::clamp((quarters - start_) / sweep_, 0.0F, 1.0F);
  return std::min(to_units(share * to_mm(length_)), length_);
}

/// Returns the angle of the last reversal up to the angle `quarters`, both in quarter turns.
float Reversals::last_until(float quarters) const {
  float last = quarters - 2.0F;
  for (const float at : turns()) {
    last = std::max(last, at + 2.0F * std::floor(0.5F * (quarters - at)));
  }
  return last;
}

float Reversals::first_behind(float quarters) const {
  float next = quarters + 2.0F;
  for (const float at : turns()) {
    next = std::min(next, at + 2.0F * std::floor(0.5F * (quarters - at)) + 2.0F);
  }
  return next;
}

void Reversals::look_on_from(PathUnits place) {
  const float quarters = start_ + sweep_ * (nearest_float(place) / nearest_float(length_));
  float passed = quarters + kSliverQuarters;
  float next = first_behind(passed);
  if (place_of(next) <= place) {
    passed = next;
    next = first_behind(next);
  }
  near_until_ = place_of(last_until(passed) + kNearQuarters);
  near_from_ = place_of(next - kNearQuarters);
  next_ = next > start_ + sweep_ - kSliverQuarters ? length_ : place_of(next);
}

}  // namespace cnc::motion

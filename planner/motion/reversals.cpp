#include "planner/motion/reversals.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {
namespace {

/// Nearer to an end of the block than this a reversal counts as there: it moves
/// the axis by R · 1e-10.
constexpr float kSliverQuarters = 1.0e-5F;

constexpr float kNearQuarters = 1.0F / 24.0F;

}  // namespace

Reversals::Reversals(const Block& block, PathUnits length) : length_{length} {
  if (!block.turns()) return;
  const float side = block.turn.half_sweep < 0.0F ? -1.0F : 1.0F;
  start_ = side * block.turn.start_angle / kHalfPi;
  sweep_ = 2.0F * std::abs(block.turn.half_sweep) / kHalfPi;
}

float Reversals::quarters_at(PathUnits place) const {
  return start_ + sweep_ * (static_cast<float>(place) / static_cast<float>(length_));
}

PathUnits Reversals::place_of(float quarters) const {
  const float share = (quarters - start_) / sweep_;
  return to_units(share * to_mm(length_));
}

PathUnits Reversals::next_after(PathUnits place) const {
  if (sweep_ <= 0.0F) return length_;
  float quarters = std::floor(quarters_at(place) + kSliverQuarters) + 1.0F;
  if (place_of(quarters) <= place) quarters += 1.0F;
  if (quarters > start_ + sweep_ - kSliverQuarters) return length_;
  return std::min(place_of(quarters), length_);
}

bool Reversals::near(PathUnits place) const {
  if (sweep_ <= 0.0F) return false;
  const float quarters = quarters_at(place);
  const float from_last = quarters - std::floor(quarters);
  return from_last < kNearQuarters || from_last > 1.0F - kNearQuarters;
}

}  // namespace cnc::motion

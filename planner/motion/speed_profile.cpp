#include "planner/motion/speed_profile.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"

namespace cnc::motion {
namespace {

/// Phases shorter than these shares of a span and of what is left of it are
/// skipped: they are rounding, and too short to move the place on the span.
constexpr float kNegligibleShareOfSpan = 1.0e-6F;
constexpr float kNegligibleShareOfRest = 1.0e-5F;

/// Above the plan by more than this an override has lowered it; else it is rounding.
constexpr float kAbovePlan = 1.0F + 1.0e-4F;

Phase make_phase(float start_square, float end_square, float distance) {
  const float start = std::sqrt(start_square);
  const float end = std::sqrt(end_square);
  const float sum = start + end;
  if (!(sum > 0.0F) || !(distance > 0.0F)) return {};
  // From the squares: the difference of two nearly equal speeds has no digits.
  return {.start_speed = start,
          .acceleration = (end_square - start_square) / (2.0F * distance),
          .duration = 2.0F * distance / sum,
          .distance = distance,
          .end_speed_square = end_square};
}

}  // namespace

void SpeedProfile::begin(const Block& block,
                         const Limits& limits,
                         const Overrides& overrides,
                         float exit_square,
                         float speed_square) {
  spans_ = Spans{block, limits};
  span_ = 0;
  within_span_ = 0.0F;
  speed_square_ = speed_square;
  replan(block, overrides, exit_square);
}

void SpeedProfile::replan(const Block& block, const Overrides& overrides, float exit_square) {
  exit_square_ = exit_square;
  static_cast<void>(brake_backwards(
      spans_, SpeedCap{block, overrides}, exit_square, [this](int span, const BrakingPoint& point) {
        braking_[static_cast<std::size_t>(span)] = point;
      }));
}

/// v² to be met at the end of the present span.
float SpeedProfile::end_target_square() const {
  const auto span = static_cast<std::size_t>(span_);
  const float ahead = span_ + 1 < spans_.count() ? braking_[span + 1].speed_square : exit_square_;
  return std::min(ahead, braking_[span].cap_square);
}

Phase SpeedProfile::next_phase(Drive drive) const {
  CNC_ASSERT(!at_end());
  const float to_span_end = spans_.length_of(span_) - within_span_;
  const BrakingPoint& plan = braking_[static_cast<std::size_t>(span_)];
  if (drive == Drive::kHalt) return brake(to_span_end, 0.0F);

  const float target = end_target_square();
  const float curve = target + 2.0F * plan.deceleration * to_span_end;
  if (speed_square_ > plan.cap_square * kAbovePlan) return brake(to_span_end, plan.cap_square);
  if (speed_square_ > curve * kAbovePlan) return brake(to_span_end, target);
  return phase_on(to_span_end);
}

/// Speed up, hold the cap or follow the braking curve, whichever comes first.
Phase SpeedProfile::phase_on(float to_span_end) const {
  const BrakingPoint& plan = braking_[static_cast<std::size_t>(span_)];
  const float cap = std::max(plan.cap_square, speed_square_);
  const float target = end_target_square();
  const float negligible =
      spans_.length_of(span_) * kNegligibleShareOfSpan + to_span_end * kNegligibleShareOfRest;

  const float distance = spans_.boundary(span_) + within_span_;
  const float acceleration = spans_.steepest(spans_.place_at(distance),
                                             spans_.place_at_boundary(span_ + 1),
                                             to_span_end,
                                             speed_square_,
                                             Travel::kForward,
                                             Change::kSpeedUp);
  const float reach = next_below(speed_square_ + 2.0F * acceleration * to_span_end);
  if (reach <= target && reach <= cap) {
    return make_phase(speed_square_, std::max(reach, speed_square_), to_span_end);
  }
  // Where the speeding-up line meets the braking curve.
  const float curve = target + 2.0F * plan.deceleration * to_span_end;
  const float slopes = 2.0F * (acceleration + plan.deceleration);
  const float meeting = slopes > 0.0F ? (curve - speed_square_) / slopes : 0.0F;
  const float peak = std::clamp(speed_square_ + 2.0F * acceleration * meeting, speed_square_, cap);
  if (peak > speed_square_) {
    const float rise = std::min(to_span_end, (peak - speed_square_) / (2.0F * acceleration));
    if (rise > negligible) return make_phase(speed_square_, peak, rise);
  }
  const float drop = std::max(0.0F, speed_square_ - target);
  const float fall = plan.deceleration > 0.0F ? drop / (2.0F * plan.deceleration) : 0.0F;
  const float level = to_span_end - fall;
  if (level > negligible) return make_phase(speed_square_, speed_square_, level);
  return make_phase(speed_square_, std::min(target, speed_square_), to_span_end);
}

/// Slow down as hard as the limits allow until v² is `target_square` or the span ends.
Phase SpeedProfile::brake(float to_span_end, float target_square) const {
  const float distance = spans_.boundary(span_) + within_span_;
  const float deceleration = spans_.steepest(spans_.place_at(distance),
                                             spans_.place_at_boundary(span_ + 1),
                                             to_span_end,
                                             speed_square_,
                                             Travel::kForward,
                                             Change::kSlowDown);
  const float needed = speed_square_ - target_square;
  const float possible = 2.0F * deceleration * to_span_end;
  if (needed <= 0.0F) return {};
  if (needed >= possible) return make_phase(speed_square_, speed_square_ - possible, to_span_end);
  return make_phase(speed_square_, target_square, needed / (2.0F * deceleration));
}

void SpeedProfile::complete(const Phase& phase) { move(phase.distance, phase.end_speed_square); }

void SpeedProfile::stop_short(float distance, float speed) { move(distance, speed * speed); }

void SpeedProfile::move(float distance, float speed_square) {
  const float length = spans_.length_of(span_);
  within_span_ += distance;
  speed_square_ = speed_square;
  if (within_span_ < length * (1.0F - 1.0e-6F)) return;
  within_span_ = 0.0F;
  ++span_;
}

}  // namespace cnc::motion

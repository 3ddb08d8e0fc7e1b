#include "planner/motion/speed_profile.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"

namespace cnc::motion {
namespace {

/// A gain in v² or a level stretch smaller than this share is rounding.
constexpr float kNegligible = 1.0e-5F;

/// A speed above the cap, or a braking steeper than planned, by more than this
/// means that an override has lowered the plan; else it is rounding.
constexpr float kAbovePlan = 1.0F + 1.0e-4F;
constexpr float kSteeperThanPlan = 1.0F + 5.0e-4F;

/// Two units in the last place of a float.
constexpr float kSpeedSquareRounding = 2.4e-7F;

/// (1 µm/s)²: slower than a step in a second.
constexpr float kStandstillSquare = 1.0e-6F;

}  // namespace

void SpeedProfile::begin(const Block& block,
                         const Limits& limits,
                         const Overrides& overrides,
                         float exit_square,
                         float speed_square) {
  spans_ = Spans{block, limits};
  span_ = 0;
  left_ = spans_.length_of(0);
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

float SpeedProfile::steepest(Change change) const {
  return spans_.steepest(spans_.place_at(spans_.boundary(span_ + 1) - left_),
                         spans_.place_at_boundary(span_ + 1),
                         left_,
                         speed_square_,
                         Travel::kForward,
                         change);
}

Phase SpeedProfile::phase_to(float end_square, float distance, float left) const {
  const float start = std::sqrt(speed_square_);
  const float sum = start + std::sqrt(end_square);
  if (!(sum > 0.0F) || !(distance > 0.0F)) return {};
  // From the squares: the difference of two nearly equal speeds has no digits.
  return {.start_speed = start,
          .acceleration = (end_square - speed_square_) / (2.0F * distance),
          .duration = 2.0F * distance / sum,
          .distance = distance,
          .end_speed_square = end_square,
          .left = left};
}

Phase SpeedProfile::next_phase(Drive drive) const {
  CNC_ASSERT(!at_end());
  const BrakingPoint& plan = braking_[static_cast<std::size_t>(span_)];
  if (drive == Drive::kHalt) return brake_to(0.0F);
  const float target = end_target_square();
  const float planned_drop = 2.0F * plan.deceleration * left_;
  if (speed_square_ > plan.cap_square * kAbovePlan) return brake_to(plan.cap_square);
  if (speed_square_ - target > planned_drop * kSteeperThanPlan) return brake_to(target);
  return speed_up_or_follow();
}

/// Speed up, hold the cap or follow the braking curve, whichever comes first.
Phase SpeedProfile::speed_up_or_follow() const {
  const BrakingPoint& plan = braking_[static_cast<std::size_t>(span_)];
  const float cap = std::max(plan.cap_square, speed_square_);
  const float target = end_target_square();
  const float acceleration = steepest(Change::kSpeedUp);
  const float reach = next_below(speed_square_ + 2.0F * acceleration * left_);
  if (reach <= target && reach <= cap) {
    return phase_to(std::max(reach, speed_square_), left_, 0.0F);
  }
  // How far before the end of the span braking from v² has to begin.
  const auto fall_from = [&](float square) {
    const float drop = std::max(0.0F, square - target);
    return plan.deceleration > 0.0F ? std::min(left_, drop / (2.0F * plan.deceleration)) : 0.0F;
  };
  // Where the speeding-up line meets the braking curve.
  const float curve = target + 2.0F * plan.deceleration * left_;
  const float slopes = acceleration + plan.deceleration;
  const float gain = slopes > 0.0F ? (curve - speed_square_) * (acceleration / slopes) : 0.0F;
  const float peak = std::clamp(speed_square_ + gain, speed_square_, cap);
  if (peak > speed_square_ * (1.0F + kNegligible)) {
    const float rise = (peak - speed_square_) / (2.0F * acceleration);
    return phase_to(peak, rise, std::max(left_ - rise, fall_from(peak)));
  }
  const float fall = fall_from(speed_square_);
  const float level = left_ - fall;
  if (level > left_ * kNegligible) return phase_to(speed_square_, level, fall);
  return phase_to(std::min(target, speed_square_), left_, 0.0F);
}

/// Below the braking curve the plan's own deceleration is feasible in the share
/// in which v² is below it, for the limits are linear in (a, v²) and hold at
/// standstill; so what the plan can stop from here can stop. (Within a span
/// the limits at the very place may be tighter than at its ends, by the margin.)
float SpeedProfile::planned_deceleration() const {
  const float planned = braking_[static_cast<std::size_t>(span_)].deceleration;
  const float curve = end_target_square() + 2.0F * planned * left_;
  return curve > speed_square_ ? planned * (speed_square_ / curve) : planned;
}

/// Slow down as hard as the limits allow until v² is `target_square` or the span ends.
Phase SpeedProfile::brake_to(float target_square) const {
  const float deceleration = std::max(steepest(Change::kSlowDown), planned_deceleration());
  const float needed = speed_square_ - target_square;
  const float possible = 2.0F * deceleration * left_;
  if (needed <= 0.0F) return {};
  if (needed >= possible) {
    // A standstill that is missed by rounding alone is met.
    const float rounding =
        possible * 1.0e-3F + speed_square_ * kSpeedSquareRounding + kStandstillSquare;
    const bool met = needed - possible <= rounding;
    return phase_to(met ? target_square : speed_square_ - possible, left_, 0.0F);
  }
  const float distance = needed / (2.0F * deceleration);
  return phase_to(target_square, distance, std::max(0.0F, left_ - distance));
}

/// The square of a speed is rounded; it must not leave the phase, whose ends
/// are within the caps.
void SpeedProfile::stop_short(const Phase& phase, float distance, float speed) {
  const auto [least, most] = std::minmax(speed_square_, phase.end_speed_square);
  move(phase.left + distance, std::clamp(speed * speed, least, most));
}

void SpeedProfile::move(float left, float speed_square) {
  left_ = left;
  speed_square_ = speed_square;
  if (left_ > 0.0F) return;
  ++span_;
  left_ = at_end() ? 0.0F : spans_.length_of(span_);
}

}  // namespace cnc::motion

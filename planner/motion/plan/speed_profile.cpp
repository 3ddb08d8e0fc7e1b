#include "planner/motion/plan/speed_profile.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"

namespace cnc::motion {
namespace {

/// Least gain of v², as a share of v², for which a phase speeds up where jerk is not limited. It is
/// ten times kNegligibleShare, because a smaller gain would be too inexact. Even a gain of this
/// size has at most four exact digits, and so has the acceleration that is computed from it.
constexpr float kMinGain = 1.0e-4F;

/// Greatest ratios that rounding explains: of v² to the cap or to the braking curve, and of the
/// required drop of v² to the planned drop. If a ratio is greater, an override has lowered the
/// plan.
constexpr float kAbovePlan = 1.0F + 1.0e-4F;
constexpr float kSteeperThanPlan = 1.0F + 5.0e-4F;

/// Greatest ratio of v² to the braking curve. Rounding alone may make the ratio greater than 1:
/// under a time window, the speed may have to stay level for a rounded time before braking
/// (Patience::before_braking).
constexpr float kLate = 1.0005F;

/// Rounding error of v², relative to v²: two units in the last place of a float.
constexpr float kSpeedSquareRounding = 2.4e-7F;

/// Greatest v² that counts as rest, in mm²/s². Without a time window this is (1 µm/s)², slower than
/// a step per second. Under a time window it is the v² that the jerk limit allows within a cell of
/// the window.
constexpr float kStandstillSquare = 1.0e-6F;
constexpr float kFilteredStandstillSquare = 1.0e-9F;

}  // namespace

void SpeedProfile::begin(const Block& block,
                         const Limits& limits,
                         const PlanTerms& terms,
                         const BrakingState& exit,
                         float speed_square) {
  speed_square_ = speed_square;
  lay_out(block, limits, terms, exit, block.length, grid_for(block, terms, exit));
  // The start speed was planned on the usual grid. If it slightly exceeds the cap or the braking
  // curve of the fine grid, the block is laid out on the usual grid instead.
  const float curve = end_target_square() + 2.0F * here().deceleration * left_;
  if (!spans_.fine() || speed_square_ <= std::min(curve, here().cap_square)) return;
  lay_out(block, limits, terms, exit, block.length, Spans::Grid::kUsual);
}

void SpeedProfile::replan(const Block& block,
                          const Limits& limits,
                          const PlanTerms& terms,
                          const BrakingState& exit) {
  const Spans::Grid grid = spans_.fine() ? Spans::Grid::kFine : Spans::Grid::kUsual;
  lay_out(block, limits, terms, exit, left_of_block({.left = left_}), grid);
}

void SpeedProfile::lay_out(const Block& block,
                           const Limits& limits,
                           const PlanTerms& terms,
                           const BrakingState& exit,
                           float left_of_block,
                           Spans::Grid grid) {
  spans_ = Spans{block, limits, terms.window, grid};
  find_span(left_of_block);
  exit_ = exit;
  brake_from_the_end(block, terms.overrides);
}

/// Returns the grid of spans for a block, see Spans::Grid. The block keeps this grid up to its end,
/// because the speeds on the fine grid may be too high for braking on the usual grid. The fine grid
/// is used only if the block begins or ends at rest. On a path of many arcs, it would save only
/// thousandths of the time, but require a third more segments.
Spans::Grid SpeedProfile::grid_for(const Block& block,
                                   const PlanTerms& terms,
                                   const BrakingState& exit) const {
  if (!block.turns() || terms.window.filters()) return Spans::Grid::kUsual;
  const bool rests = std::min(speed_square_, exit.speed_square) <= 0.0F;
  return rests ? Spans::Grid::kFine : Spans::Grid::kUsual;
}

/// Computes the braking curve from the end of the block back to the present span.
void SpeedProfile::brake_from_the_end(const Block& block, const Overrides& overrides) {
  const SpeedCap cap{block, overrides};
  const auto keep = [this](int span, const BrakingPoint& point) {
    braking_[static_cast<std::size_t>(span)] = point;
  };
  if (!block.turns() && spans_.window_s() <= 0.0F) {
    const float cap_square = cap.square_within(block.speed_limit_square);
    keep(span_,
         {.end = {.speed_square = std::min(exit_.speed_square, cap_square)},
          .deceleration = block.acceleration,
          .cap_square = cap_square});
    return;
  }
  static_cast<void>(brake_backwards(spans_, cap, exit_, keep, span_));
}

/// Sets span_ and left_ for the position `left_of_block` mm before the end of the block. This is
/// required after each change of the limit zones, because their edges are boundaries of spans.
void SpeedProfile::find_span(float left_of_block) {
  const float length = spans_.boundary(spans_.count());
  span_ = 0;
  left_ = spans_.length_of(0);
  if (left_of_block >= length) return;
  while (span_ + 1 < spans_.count() && length - spans_.boundary(span_ + 1) >= left_of_block) {
    ++span_;
  }
  left_ = left_of_block - (length - spans_.boundary(span_ + 1));
}

float SpeedProfile::steepest(Change change, float growing, float max_square) const {
  return spans_.steepest(span_,
                         spans_.place_at(spans_.boundary(span_ + 1) - left_),
                         spans_.place_at_boundary(span_ + 1),
                         {left_, speed_square_, max_square, Travel::kForward, change, growing});
}

Phase SpeedProfile::phase_to(float end_square, float distance, float left) const {
  const float start = std::sqrt(speed_square_);
  const float sum = start + std::sqrt(end_square);
  if (!(sum > 0.0F) || !(distance > 0.0F)) return {};
  // Computed from the squares, because the difference of two nearly equal speeds has no exact
  // digits.
  return {.start_speed = start,
          .acceleration = (end_square - speed_square_) / (2.0F * distance),
          .duration = 2.0F * distance / sum,
          .distance = distance,
          .end_speed_square = end_square,
          .left = left};
}

Phase SpeedProfile::next_phase(Drive drive, const Patience& patience) const {
  CNC_ASSERT(!at_end());
  if (drive == Drive::kHalt) return brake_to(0.0F, patience);
  const float target = end_target_square();
  const float planned_drop = 2.0F * here().deceleration * left_;
  if (speed_square_ > here().cap_square * kAbovePlan) return brake_to(here().cap_square, patience);
  if (speed_square_ - target > planned_drop * kSteeperThanPlan) return brake_to(target, patience);
  return change_speed(patience);
}

bool SpeedProfile::too_fast(const Patience& patience) const {
  const float curve = end_target_square() + 2.0F * here().deceleration * left_;
  const float committed = here().committed(left_, patience.before_braking);
  const float most = std::min({curve, here().cap_square, square(committed)});
  return speed_square_ > most * kAbovePlan;
}

bool SpeedProfile::within_other_zones(const BlockZones& before) const {
  const float left = left_of_block({.left = left_});
  const BlockZones& now = spans_.tail();
  return std::any_of(now.begin(), now.end(), [&](const LimitZone& zone) {
    return zone.length > left && std::find(before.begin(), before.end(), zone) == before.end();
  });
}

bool SpeedProfile::too_fast_to_turn(const BlockZones& before) const {
  const BlockZones& now = spans_.tail();
  return std::any_of(now.begin(), now.end(), [&](const LimitZone& zone) {
    const bool known = std::any_of(before.begin(), before.end(), [&zone](const LimitZone& old) {
      return old.length >= zone.length && both(old.turning, zone.turning) == old.turning;
    });
    return !known && speed_square_ > zone.turning.speed_limit_square(spans_.window_s());
  });
}

/// Returns the next phase: it speeds up, keeps the speed, or follows the braking curve.
Phase SpeedProfile::change_speed(const Patience& patience) const {
  if (patience.before_braking > 0.0F && patience.overtaken) {
    return level_for(patience.before_braking);
  }
  if (patience.before_speeding_up > 0.0F) {
    return level_or_follow(std::sqrt(speed_square_) * patience.before_speeding_up);
  }
  const Phase up = committed(speed_up());
  // At the end of a span, any gain is accepted, so that the speed also rises along a chain of very
  // short spans.
  const float min_gain = spans_.window_s() > 0.0F ? kNegligibleShare : kMinGain;
  const bool worth_it = up.left <= 0.0F || up.end_speed_square > speed_square_ * (1.0F + min_gain);
  return worth_it && up.distance > 0.0F ? up : level_or_follow(left_);
}

/// Returns the phase that speeds up until it reaches the cap, the braking curve or the end of the
/// span.
Phase SpeedProfile::speed_up() const {
  const float cap = here().cap_square;
  if (speed_square_ >= cap) return {};
  const float target = end_target_square();
  const float acceleration = steepest(Change::kSpeedUp, left_, cap);
  const float reach = next_below(speed_square_ + 2.0F * acceleration * left_);
  if (reach <= target && reach <= cap) {
    return phase_to(std::max(reach, speed_square_), left_, 0.0F);
  }
  // Computes v² where the line of speeding up intersects the braking curve. Both are linear in
  // distance.
  const float curve = target + 2.0F * here().deceleration * left_;
  const float slopes = acceleration + here().deceleration;
  const float gain = slopes > 0.0F ? (curve - speed_square_) * (acceleration / slopes) : 0.0F;
  const float peak = std::clamp(speed_square_ + gain, speed_square_, cap);
  if (peak <= speed_square_) return {};
  // Distances of braking (`fall`) and of speeding up (`rise`). Each is computed from a small
  // difference of large v², so the distance with the greater acceleration has the smaller error. If
  // this distance is `fall`, `rise` is at most the length that `fall` leaves.
  const float fall = fall_from(peak);
  float rise = (peak - speed_square_) / (2.0F * acceleration);
  const bool steeper_fall = acceleration < here().deceleration;
  if (spans_.window_s() <= 0.0F && steeper_fall) rise = std::min(rise, left_ - fall);
  return phase_to(peak, rise, std::max(left_ - rise, fall));
}

/// Returns the first part of `phase`, in which the speed rises. This part ends early enough that
/// the speed can stay level for the time window before braking.
Phase SpeedProfile::committed(const Phase& phase) const {
  const float window_s = spans_.window_s();
  if (window_s <= 0.0F || phase.distance <= 0.0F) return phase;
  const float gain = 2.0F * phase.acceleration;
  const auto too_fast = [&](float distance) {
    const float most = here().committed(left_ - distance, window_s);
    return speed_square_ + gain * distance > square(most);
  };
  if (!too_fast(phase.distance)) return phase;
  constexpr int kBisections = 22;
  float short_of = 0.0F;
  float beyond = phase.distance;
  for (int i = 0; i < kBisections; ++i) {
    const float middle = 0.5F * (short_of + beyond);
    (too_fast(middle) ? beyond : short_of) = middle;
  }
  // At rest, this part can be too short to be computed. Then the whole phase is driven.
  if (short_of <= 0.0F && speed_square_ <= 0.0F) return phase;
  return phase_to(speed_square_ + gain * short_of, short_of, left_ - short_of);
}

/// Returns the distance in mm before the end of the present span at which braking from a v² of
/// `speed_square` has to begin.
float SpeedProfile::fall_from(float speed_square) const {
  const float drop = std::max(0.0F, speed_square - end_target_square());
  const float deceleration = here().deceleration;
  return deceleration > 0.0F ? std::min(left_, drop / (2.0F * deceleration)) : 0.0F;
}

Phase SpeedProfile::level_or_follow(float longest_level) const {
  const float fall = fall_from(speed_square_);
  const float level = left_ - fall;
  if (level > longest_level) {
    return phase_to(speed_square_, longest_level, left_ - longest_level);
  }
  if (fall <= 0.0F) return level_on();
  if (level > left_ * kNegligibleShare) return phase_to(speed_square_, level, fall);
  return phase_to(std::min(end_target_square(), speed_square_), left_, 0.0F);
}

/// Returns the phase that keeps the speed to the end of the span, and through the following spans
/// in which the speed stays level, too.
Phase SpeedProfile::level_on() const {
  int last = span_;
  if (spans_.window_s() <= 0.0F) {
    while (last + 1 < spans_.count() && point_of(last + 1).stays_level(speed_square_)) {
      ++last;
    }
  }
  const float beyond = spans_.boundary(last + 1) - spans_.boundary(span_ + 1);
  Phase phase = phase_to(speed_square_, left_ + beyond, 0.0F);
  phase.passes = last - span_;
  return phase;
}

Phase SpeedProfile::level_for(float seconds) const {
  const float distance = std::min(left_, std::sqrt(speed_square_) * seconds);
  return phase_to(speed_square_, distance, left_ - distance);
}

/// Returns the deceleration of the plan at the present speed, or 0 if the plan does not allow this
/// speed.
///
/// Below the braking curve, where v² < `curve`, the share v² / curve of the plan's deceleration is
/// feasible, because the limits are linear in (a, v²) and allow rest. So if the plan can stop from
/// the present position, the motion can, too. (The limits at a position within a span may be
/// stricter than those at the span's ends, by the margin of ArcLimits.) The plan does not allow a
/// speed above the curve. Under a time window it does not allow a speed above the cap either,
/// because turning leaves less acceleration there. A speed that the plan does not allow is caused
/// by an override that has lowered the plan.
float SpeedProfile::planned_deceleration() const {
  const float planned = here().deceleration;
  const bool beyond_cap = speed_square_ > here().cap_square * kAbovePlan;
  if (spans_.window_s() > 0.0F && beyond_cap) return 0.0F;
  const float curve = end_target_square() + 2.0F * planned * left_;
  if (speed_square_ < curve) return planned * (speed_square_ / curve);
  return speed_square_ <= curve * kLate ? planned * (speed_square_ / curve) : 0.0F;
}

/// Returns the phase that slows down as hard as the limits allow, until v² is `target_square` or
/// the span ends.
Phase SpeedProfile::brake_to(float target_square, const Patience& patience) const {
  if (patience.before_braking > 0.0F) return level_for(patience.before_braking);
  // If an override has made the speed too high, braking uses the limits in full. Otherwise braking
  // leaves a part of the limits unused, because the motion, a mean of the plan over time, is faster
  // than the plan while the plan brakes. After an override, the motion may also be faster than the
  // lowered cap.
  const float growing = patience.overtaken ? 0.0F : left_;
  float cap = std::max(here().cap_square, speed_square_);
  if (patience.overtaken) cap = std::max(cap, square(patience.braking_from));
  const float deceleration =
      std::max(steepest(Change::kSlowDown, growing, cap), planned_deceleration());
  const float needed = speed_square_ - target_square;
  const float possible = 2.0F * deceleration * left_;
  if (needed <= 0.0F) return {};
  if (needed >= possible) {
    // If only rounding prevents the target speed from being reached, it counts as reached.
    const float standstill =
        spans_.window_s() > 0.0F ? kFilteredStandstillSquare : kStandstillSquare;
    const float rounding = possible * 1.0e-3F + speed_square_ * kSpeedSquareRounding + standstill;
    const bool met = needed - possible <= rounding;
    return phase_to(met ? target_square : speed_square_ - possible, left_, 0.0F);
  }
  const float distance = needed / (2.0F * deceleration);
  return phase_to(target_square, distance, std::max(0.0F, left_ - distance));
}

/// Limits v² to the range between its values at the ends of the phase, which are within the caps.
/// The square of `speed` is rounded and could be outside this range.
void SpeedProfile::stop_short(const Phase& phase, float distance, float speed) {
  const auto [least, most] = std::minmax(speed_square_, phase.end_speed_square);
  const float speed_square = std::clamp(speed * speed, least, most);
  if (phase.passes == 0) return move(phase.left + distance, speed_square);
  find_span(left_of_block(phase) + distance);
  move(left_, speed_square);
}

void SpeedProfile::move(float left, float speed_square) {
  left_ = left;
  speed_square_ = speed_square;
  if (left_ > 0.0F) return;
  ++span_;
  left_ = at_end() ? 0.0F : spans_.length_of(span_);
}

}  // namespace cnc::motion

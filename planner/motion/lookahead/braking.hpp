#pragma once

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/lookahead/spans.hpp"
#include "planner/motion/lookahead/speed_cap.hpp"

namespace cnc::motion {

/// Greatest share that counts as rounding. A gain of v² is compared with v². The length of a phase
/// at level speed is compared with the distance to the end of the span.
inline constexpr float kNegligibleShare = 1.0e-5F;

/// Returns the speed, in mm/s, up to which the motion may speed up, because it can then keep this
/// speed for the time window before it brakes; see BrakingState.
/// @param commit_square, steepest X and a of BrakingState
/// @param window_s length T of the time window in s
[[nodiscard]] inline float commit_speed(float commit_square, float steepest, float window_s) {
  const float lead = steepest * window_s;
  // Computed as X / (sqrt(X + lead²) + lead), because the difference would lose digits.
  const float sum = std::sqrt(commit_square + square(lead)) + lead;
  return sum > 0.0F ? commit_square / sum : 0.0F;
}

/// The braking curve within one span.
struct BrakingPoint {
  BrakingState end{};         ///< State at the end of the span; its v² is within the span's cap.
  float deceleration = 0.0F;  ///< Deceleration towards the end of the span, mm/s² ≥ 0.
  float cap_square = 0.0F;    ///< Greatest v² within the span, with feed and overrides.
  float steepest = 0.0F;      ///< Greatest braking deceleration in the span and after it, mm/s².

  /// Returns X of BrakingState, in mm²/s², at the position `left` mm before the end of the span.
  [[nodiscard]] float commit_square(float left) const {
    if (cap_square <= end.speed_square) return end.commit_square + 2.0F * steepest * left;
    const float slope = end.speed_square + 2.0F * deceleration * left;
    if (slope <= cap_square || deceleration <= 0.0F) return slope;
    return cap_square + (slope - cap_square) * (steepest / deceleration);
  }
  /// Returns the greatest speed, in mm/s, with which all limits ahead can be kept if braking begins
  /// only after `wait_s` seconds at this speed. The motion is `left` mm before the end of the span.
  [[nodiscard]] float committed(float left, float wait_s) const {
    // Lowers the result by the rounding error of a speed. With v / a = 2 s, the last digit of v
    // corresponds to 0.2 µs of `wait_s`.
    constexpr float kSurely = 1.0F - 4.8e-7F;
    const float braked = kSurely * commit_speed(commit_square(left), steepest, wait_s);
    return std::max(braked, std::min(end.kept, std::sqrt(cap_square)));
  }
  /// Returns whether a motion with v² = `speed_square` keeps its speed within the span, because it
  /// can neither speed up nor has to brake there. @pre there is no time window
  [[nodiscard]] bool stays_level(float speed_square) const {
    return cap_square >= speed_square && cap_square <= speed_square * (1.0F + kNegligibleShare) &&
           end.speed_square >= speed_square;
  }
};

/// Returns the state at the start of a span.
/// @param point braking curve within the span, with the state at its end
/// @param length length of the span, mm
[[nodiscard]] BrakingState start_of(const BrakingPoint& point, float length, float window_s);

/// Performs the backward pass over one block. Calls `visit(span, point)` for each span from the
/// last one back to the span `first`, with its BrakingPoint. Returns the state at the start of the
/// last visited span from which `exit` can be reached at the end of the block.
///
/// The limits of the axes' accelerations are linear in the path acceleration a and in v², and allow
/// a = 0 below the speed limit. So the values of v² from which braking is possible always form an
/// interval from 0, and it is optimal to take the largest value span by span (Pham and Pham, "A new
/// approach to time-optimal path parameterization", IEEE T-RO 34(3), 2018).
template <typename Visitor>
BrakingState brake_backwards(const Spans& spans,
                             const SpeedCap& cap,
                             const BrakingState& exit,
                             Visitor&& visit,
                             int first = 0) {
  Place end = spans.place_at_boundary(spans.count());
  float end_mm = spans.boundary(spans.count());
  BrakingState state = exit;
  for (int span = spans.count() - 1; span >= first; --span) {
    const Place start = spans.place_at_boundary(span);
    const float start_mm = spans.boundary(span);
    const float length = end_mm - start_mm;
    const float cap_square = std::min(cap.square_within(spans.speed_limit_square(span, start, end)),
                                      spans.zone_speed_square(span));
    if (cap_square < state.speed_square) state.speed_square = cap_square;
    const float deceleration = spans.steepest(
        span,
        end,
        start,
        {length, state.speed_square, cap_square, Travel::kBackward, Change::kSlowDown, length});
    const BrakingPoint point{.end = state,
                             .deceleration = deceleration,
                             .cap_square = cap_square,
                             .steepest = std::max(deceleration, state.steepest)};
    visit(span, point);
    state = start_of(point, length, spans.window_s());
    end = start;
    end_mm = start_mm;
  }
  return state;
}

/// Returns the greatest v² at the start of a straight block into which no limit zones of
/// neighbouring blocks reach. Most blocks are of this kind.
[[nodiscard]] inline float brake_over_line(const Block& block,
                                           const SpeedCap& cap,
                                           float exit_square) {
  const float cap_square = cap.square_within(block.speed_limit_square);
  const float end = std::min(exit_square, cap_square);
  const float from = next_below(end + 2.0F * block.acceleration * block.length);
  return std::min(cap_square, std::max(end, from));
}

[[nodiscard]] inline BrakingState brake_backwards(const Spans& spans,
                                                  const SpeedCap& cap,
                                                  const BrakingState& exit) {
  return brake_backwards(spans, cap, exit, [](int, const BrakingPoint&) {});
}

}  // namespace cnc::motion

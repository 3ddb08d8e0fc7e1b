#pragma once

#include <algorithm>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/spans.hpp"
#include "planner/motion/speed_cap.hpp"

namespace cnc::motion {

/// The greatest speed from which a span can still be driven within the limits.
struct BrakingPoint {
  float speed_square;  ///< At the start of the span.
  float deceleration;  ///< Towards its end, mm/s² ≥ 0.
  float cap_square;    ///< Within the span, after feed and overrides.
};

/// Backward pass over one block: visits its spans from last to first with their
/// BrakingPoints and returns the greatest v² at which the block may be entered
/// so that `exit_square` can be met at its end.
///
/// Because the acceleration limits are linear in (a, v²) and allow a = 0 below
/// the speed limit, what can be braked from is always an interval from 0, and
/// taking the largest value span by span is optimal (Pham and Pham, "A new
/// approach to time-optimal path parameterization", IEEE T-RO 34(3), 2018).
template <typename Visitor>
float brake_backwards(const Spans& spans, const SpeedCap& cap, float exit_square, Visitor&& visit) {
  Place end = spans.place_at_boundary(spans.count());
  float speed_square = exit_square;
  for (int span = spans.count() - 1; span >= 0; --span) {
    const Place start = spans.place_at_boundary(span);
    const float length = spans.length_of(span);
    const float cap_square = cap.square_within(spans.speed_limit_square(span));
    speed_square = std::min(speed_square, cap_square);
    const float deceleration =
        spans.steepest(end, start, length, speed_square, Travel::kBackward, Change::kSlowDown);
    // Rounded down, so that the speeds as stored never ask for more.
    const float from = next_below(speed_square + 2.0F * deceleration * length);
    speed_square = std::min(cap_square, std::max(speed_square, from));
    visit(span, BrakingPoint{speed_square, deceleration, cap_square});
    end = start;
  }
  return speed_square;
}

[[nodiscard]] inline float brake_backwards(const Spans& spans,
                                           const SpeedCap& cap,
                                           float exit_square) {
  return brake_backwards(spans, cap, exit_square, [](int, const BrakingPoint&) {});
}

}  // namespace cnc::motion

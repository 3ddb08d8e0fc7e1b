#include "planner/motion/lookahead/braking.hpp"

namespace cnc::motion {

BrakingState start_of(const BrakingPoint& point, float length, float window_s) {
  // Rounded down, so that braking from this v² never requires more than `point.deceleration`.
  const float end_square = point.end.speed_square;
  const float from = next_below(end_square + 2.0F * point.deceleration * length);
  BrakingState start;
  start.speed_square = std::min(point.cap_square, std::max(end_square, from));
  start.steepest = point.steepest;
  start.commit_square = point.commit_square(length);
  // If only the cap limits the state at the start, the path after the span has no effect on the
  // states before the span. Then X of BrakingState is made just large enough that commit_speed()
  // returns the cap.
  if (window_s <= 0.0F) return start;
  const float cap = std::sqrt(point.cap_square);
  start.kept = std::min(cap, point.committed(length, window_s));
  if (start.speed_square >= point.cap_square &&
      commit_speed(start.commit_square, start.steepest, window_s) >= cap) {
    start.steepest = point.deceleration;
    start.commit_square = point.cap_square + 2.0F * cap * point.deceleration * window_s;
  }
  return start;
}

}  // namespace cnc::motion

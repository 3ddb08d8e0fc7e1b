#include "tests/support/straight_move.hpp"

#include <cmath>

namespace sim {
namespace {

/// Returns the ramp from rest to a speed: the time of its jerk phases and of the level phase
/// between them.
StraightMove ramp_to(double speed, double acceleration, double jerk) {
  StraightMove move{.peak_speed = speed};
  const double rise = acceleration / jerk;
  if (speed >= acceleration * rise) {
    move.jerk_time = rise;
    move.level_time = speed / acceleration - rise;
  } else {
    move.jerk_time = std::sqrt(speed / jerk);
  }
  return move;
}

/// Returns the duration of a ramp. The ramp and its mirror image together cover peak speed times
/// this duration.
double ramp_seconds(const StraightMove& move) { return 2.0 * move.jerk_time + move.level_time; }

/// Returns the peak speed at which both ramps meet: v²/A + v A/J = length, or 2 v √(v/J) = length
/// if A is not reached.
double meeting_speed(double length, double acceleration, double jerk) {
  const double rise = acceleration / jerk;
  const double speed = 2.0 * length / (rise + std::sqrt(rise * rise + 4.0 * length / acceleration));
  if (speed >= acceleration * rise) return speed;
  return std::cbrt(length * length * jerk / 4.0);
}

}  // namespace

StraightMove straight_move(double length, double speed, double acceleration, double jerk) {
  if (length <= 0.0) return {};
  StraightMove move = ramp_to(speed, acceleration, jerk);
  if (std::isinf(speed) || speed * ramp_seconds(move) > length) {
    return ramp_to(meeting_speed(length, acceleration, jerk), acceleration, jerk);
  }
  move.cruise_time = length / speed - ramp_seconds(move);
  return move;
}

}  // namespace sim

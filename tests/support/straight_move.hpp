#pragma once

namespace sim {

/// The fastest straight move from rest to rest with limited speed, acceleration and jerk, as the
/// durations of its seven phases; it is symmetric in time.
///
/// It is the classical double-S profile (Biagiotti and Melchiorri, Trajectory Planning for
/// Automatic Machines and Robots, 2008, section 3.4) in closed form, exact except for rounding. A
/// limit may be infinity.
struct StraightMove {
  double jerk_time = 0.0;    ///< Duration of each of the four phases with the greatest jerk, s.
  double level_time = 0.0;   ///< Duration of each of the two phases with constant acceleration, s.
  double cruise_time = 0.0;  ///< Duration of the phase with constant speed, s.
  double peak_speed = 0.0;   ///< Greatest speed, mm/s.

  [[nodiscard]] double seconds() const { return 4.0 * jerk_time + 2.0 * level_time + cruise_time; }
};

/// Computes the move. @param length mm ≥ 0 @param speed mm/s @param acceleration mm/s²
/// @param jerk mm/s³
[[nodiscard]] StraightMove straight_move(double length,
                                         double speed,
                                         double acceleration,
                                         double jerk);

}  // namespace sim

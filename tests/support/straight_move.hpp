#pragma once

namespace sim {

/// The fastest straight move from rest to rest with limited speed, acceleration
/// and jerk: the seven phases whose lengths in time are given here, the same on both sides.
///
/// The classical double-S profile (Biagiotti and Melchiorri, Trajectory Planning for
/// Automatic Machines and Robots, 2008, section 3.4) in closed form; exact but for rounding,
/// relative error below 1e-12. A limit may be infinity.
struct StraightMove {
  double jerk_time = 0.0;    ///< s, of each of the four phases of greatest jerk.
  double level_time = 0.0;   ///< s, of each of the two phases of constant acceleration.
  double cruise_time = 0.0;  ///< s, of the phase of constant speed.
  double peak_speed = 0.0;   ///< mm/s.

  [[nodiscard]] double seconds() const { return 4.0 * jerk_time + 2.0 * level_time + cruise_time; }
};

/// @param length mm ≥ 0. @param speed mm/s. @param acceleration mm/s². @param jerk mm/s³.
[[nodiscard]] StraightMove straight_move(double length,
                                         double speed,
                                         double acceleration,
                                         double jerk);

}  // namespace sim

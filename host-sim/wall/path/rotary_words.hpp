#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace sim::wall {

/// The rotary axes of a machine: one that tilts the beam, and C about Z.
enum class RotaryAxes : std::uint8_t {
  kAC,  ///< A tilts about X.
  kBC,  ///< B tilts about Y.
};

/// Rotation of the beam relative to the part by both axes, degrees, right-handed about the plus
/// axis (ISO 841).
struct RotaryWords {
  double tilt = 0.0;
  double turn = 0.0;
};

/// A tilt below that is none, degrees: C stays as it is.
inline constexpr double kNoTiltDeg = 1.0e-6;

/// Returns the unit vector from the tip to the lens: (sin c sin a, -cos c sin a, cos a) with A, and
/// (cos c sin b, sin c sin b, cos b) with B.
[[nodiscard]] Eigen::Vector3d axis_of(RotaryAxes axes, const RotaryWords& words);

/// Returns the words of an axis, a unit vector: of (t, c) and (-t, c + 180) those that are nearer
/// to the last words, with C unwrapped to the nearest turn. Without a tilt C stays.
[[nodiscard]] RotaryWords words_of(RotaryAxes axes,
                                   const Eigen::Vector3d& axis,
                                   const RotaryWords& last);

/// Returns the words of an axis with a tilt of at least 0 and C from -180 to 180.
[[nodiscard]] RotaryWords first_words_of(RotaryAxes axes, const Eigen::Vector3d& axis);

}  // namespace sim::wall

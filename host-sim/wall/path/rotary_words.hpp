#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace sim::wall {

/// The rotary axes of a machine: an axis that tilts the beam, and C about Z.
enum class RotaryAxes : std::uint8_t {
  kAC,  ///< A tilts about X.
  kBC,  ///< B tilts about Y.
};

/// Angles of both rotary axes, in degrees: the rotation of the beam relative to the part,
/// right-handed about the positive axis (ISO 841).
struct RotaryWords {
  double tilt = 0.0;
  double turn = 0.0;
};

/// Tilt in degrees below which the beam counts as upright and C keeps its value.
inline constexpr double kNoTiltDeg = 1.0e-6;

/// Returns the unit vector from the tip to the lens: (sin c sin a, -cos c sin a, cos a) with A, and
/// (cos c sin b, sin c sin b, cos b) with B.
[[nodiscard]] Eigen::Vector3d axis_of(RotaryAxes axes, const RotaryWords& words);

/// Returns the rotary words for a beam along `axis`, a unit vector. Of the equivalent pairs (t, c)
/// and (-t, c + 180), returns the pair that is nearer to the last words. C is changed by a multiple
/// of 360 degrees to the value nearest to the last C. Without a tilt, C keeps its value.
[[nodiscard]] RotaryWords words_of(RotaryAxes axes,
                                   const Eigen::Vector3d& axis,
                                   const RotaryWords& last);

/// Returns the words of an axis, a unit vector, with a tilt of at least 0 and C from -180 to 180.
[[nodiscard]] RotaryWords first_words_of(RotaryAxes axes, const Eigen::Vector3d& axis);

}  // namespace sim::wall

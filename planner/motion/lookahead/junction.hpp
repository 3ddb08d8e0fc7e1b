#pragma once

#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// How the path continues between two blocks, as far as the caller knows it.
enum class Joint : std::uint8_t {
  kAsItTurns,  ///< Nothing is known: the tangents decide.
  kSmooth,     ///< The path does not turn, except for rounding to a nanometre.
  kStop,       ///< The machine is at rest at the joint.
};

/// The greatest turn, in radians, that counts as none. There, an axis that runs at 500 mm/s changes
/// its speed by 0.1 mm/s. 1000 mm/s² do this in a tenth of the time of a slice, over a distance of
/// 5 nm. A larger turn needs a blend or a stop.
inline constexpr float kTangentTurn = 2.0e-4F;

/// Returns whether the path continues straight, within kTangentTurn. No machine turns on the spot,
/// so a joint is passed at any speed or at rest.
/// @param before, after unit tangents on either side
[[nodiscard]] bool is_tangent(const AxisArray<float>& before, const AxisArray<float>& after);

/// Returns |after − before|². It is computed from the difference and not from the dot product,
/// which has lost the angle near a tangent joint.
[[nodiscard]] float turn_square(const AxisArray<float>& before, const AxisArray<float>& after);

}  // namespace cnc::motion

#pragma once

#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// The caller's knowledge about the path at the point where two blocks meet.
enum class Joint : std::uint8_t {
  kAsItTurns,  ///< Nothing is known: the look-ahead compares the tangents.
  kSmooth,     ///< The path does not change its direction, except for rounding to a nanometre.
  kStop,       ///< The machine is at rest at the joint.
};

/// Greatest change of direction, in radians, at which the path counts as straight. At a path speed
/// of 500 mm/s, this change alters the speed of an axis by 0.1 mm/s. With an acceleration of 1000
/// mm/s², the axis requires 0.1 ms for this, a tenth of a slice, and deviates by 5 nm. A larger
/// change of direction requires a blend or a stop.
inline constexpr float kTangentTurn = 2.0e-4F;

/// Returns whether the path continues in the same direction, within kTangentTurn. A larger change
/// of direction requires a stop. A lower speed at the joint would not be enough, because no machine
/// can change its direction of travel in zero time.
/// @param before, after unit tangents of the path before and after the joint
[[nodiscard]] bool is_tangent(const AxisArray<float>& before, const AxisArray<float>& after);

/// Returns |after − before|². It is computed from the difference and not from the dot product,
/// which has too few digits at a nearly tangent joint.
[[nodiscard]] float turn_square(const AxisArray<float>& before, const AxisArray<float>& after);

}  // namespace cnc::motion

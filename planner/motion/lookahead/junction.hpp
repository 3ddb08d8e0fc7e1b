#pragma once

#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// What the path does between two blocks, as far as is known from elsewhere.
enum class Joint : std::uint8_t {
  kAsItTurns,  ///< Nothing is known: what the tangents say.
  kSmooth,     ///< It does not turn, but for the rounding of places to a nanometre.
  kStop,       ///< The machine stands still.
};

/// The turn, in radians, that is taken for none. An axis that runs at 500 mm/s
/// changes its speed by 0.1 mm/s there: what 1000 mm/s² give it in a tenth of
/// the time of a slice, on a way of 5 nm. A larger turn needs a blend or a stop.
inline constexpr float kTangentTurn = 2.0e-4F;

/// Whether the path goes straight on, within kTangentTurn. No machine turns on the
/// spot, so a joint is taken at any speed or at rest.
/// @param before, after unit tangents on either side.
[[nodiscard]] bool is_tangent(const AxisArray<float>& before, const AxisArray<float>& after);

/// |after − before|², from the difference and not from the dot product: near a
/// tangent joint the latter has lost the angle.
[[nodiscard]] float turn_square(const AxisArray<float>& before, const AxisArray<float>& after);

}  // namespace cnc::motion

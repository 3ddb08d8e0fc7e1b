#pragma once

#include "planner/motion/limits.hpp"

namespace cnc::motion {

/// The square of the speed at which a corner may be taken, mm²/s².
///
/// Grbl's junction deviation: the speed at which a circle that touches both
/// tangents and stays within $11 of the corner could be driven with the
/// acceleration that the axes allow along the change of direction.
/// With turn angle β: v² = a · $11 · cos(β/2) / (1 − cos(β/2)).
///
/// @param before, after unit tangents on either side.
/// Guarantee: 0 for a reversal, kNoCornerLimit for tangents that agree within
/// 0.08°, never negative.
inline constexpr float kNoCornerLimit = 1.0e12F;
[[nodiscard]] float corner_speed_square(const AxisArray<float>& before,
                                        const AxisArray<float>& after,
                                        const Limits& limits);

}  // namespace cnc::motion

#pragma once

#include <numbers>

namespace sim::pocket {

/// Bulge of a quarter turn to the left: the tangent of a quarter of this turn.
inline constexpr double kQuarterTurnBulge = std::numbers::sqrt2 - 1.0;

}  // namespace sim::pocket

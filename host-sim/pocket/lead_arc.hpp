#pragma once

#include <numbers>

namespace sim::pocket {

/// Bulge of a quarter turn to the left: tan(90° / 4).
inline constexpr double kQuarterTurnBulge = std::numbers::sqrt2 - 1.0;

}  // namespace sim::pocket

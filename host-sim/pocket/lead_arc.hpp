#pragma once

#include <numbers>

namespace sim::pocket {

/// The bulge of a quarter turn to the left: tan of a quarter of it.
inline constexpr double kQuarterTurnBulge = std::numbers::sqrt2 - 1.0;

}  // namespace sim::pocket

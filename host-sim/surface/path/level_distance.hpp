#pragma once

#include "planner/surface/profile.hpp"

namespace sim::surface {

/// Returns the distance between levels in Z at which a tool leaves at most `scallop_mm`, measured
/// perpendicular to the surface, on slopes of at least 45 degrees. On flatter slopes more stock is
/// left between levels.
/// @param scallop_mm greatest height of the stock, above 0
[[nodiscard]] double level_distance(const cnc::surface::Profile& tool, double scallop_mm);

}  // namespace sim::surface

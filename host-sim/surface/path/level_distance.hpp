#pragma once

#include "planner/surface/profile.hpp"

namespace sim::surface {

/// Returns the greatest distance in Z between levels at which a tool leaves stock of at most
/// `scallop_mm` between them. The stock is measured perpendicular to the surface, on slopes of at
/// least 45 degrees. On flatter slopes, more stock is left.
/// @param scallop_mm greatest height of the left stock, above 0
[[nodiscard]] double level_distance(const cnc::surface::Profile& tool, double scallop_mm);

}  // namespace sim::surface

#pragma once

#include "planner/surface/profile.hpp"

namespace sim::surface {

/// Returns the distance of levels in Z between which a tool leaves no more than `scallop_mm`, at
/// right angles to the surface, where that is as steep as 45 degrees or more. Less steep ones have
/// more left between levels. @param scallop_mm above 0
[[nodiscard]] double level_distance(const cnc::surface::Profile& tool, double scallop_mm);

}  // namespace sim::surface

#pragma once

#include <vector>

#include "host-sim/surface/path/distance_map.hpp"
#include "host-sim/surface/path/level_loops.hpp"

namespace sim::surface {

/// Returns the lines of equal distance from the border of an area, over its surface: the first a
/// quarter of a step within the border, then one every step. More lines go round whatever is
/// farther than `most_mm` from these: the middle of the area, and places at ridges of the distance,
/// where lines have corners. The farther side is on their right, and the levels count from the
/// border inwards. @param most_mm greatest distance from a line, at least half a step
[[nodiscard]] std::vector<LevelLoop> distance_loops(const SurfaceTracer& tracer,
                                                    const TipGrid& tips,
                                                    double step_mm,
                                                    double most_mm);

}  // namespace sim::surface

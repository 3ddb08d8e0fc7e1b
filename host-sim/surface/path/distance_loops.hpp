#pragma once

#include <vector>

#include "host-sim/surface/path/distance_map.hpp"
#include "host-sim/surface/path/level_loops.hpp"

namespace sim::surface {

/// Returns the lines of equal distance from the border of an area, measured over its surface. The
/// first line is a quarter of a step from the border, the next ones a step from each other. Further
/// lines surround all places that are farther than `max_mm` from these lines: the middle of the
/// area, and ridges of the distance, where lines have corners. The side with greater distance is on
/// the right of each line, and the levels count from the border inwards.
/// @param max_mm greatest distance from a line, at least half a step
[[nodiscard]] std::vector<LevelLoop> distance_loops(const SurfaceTracer& tracer,
                                                    const TipGrid& tips,
                                                    double step_mm,
                                                    double max_mm);

}  // namespace sim::surface

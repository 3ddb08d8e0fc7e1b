#pragma once

#include <vector>

#include "host-sim/surface/path/distance_map.hpp"
#include "host-sim/surface/path/level_loops.hpp"

namespace sim::surface {

/// Returns lines of equal distance from the border of an area, measured over its surface. The first
/// line is a quarter of a step from the border; the following lines are a step apart. Additional
/// lines surround all points that are farther than `max_mm` from these lines, in the middle of the
/// area and at corners of lines. The side with the greater distance is on the right of each line.
/// Levels count from the border inwards.
/// @param max_mm greatest permitted distance of a point from a line, at least half a step
[[nodiscard]] std::vector<LevelLoop> distance_loops(const SurfaceTracer& tracer,
                                                    const TipGrid& tips,
                                                    double step_mm,
                                                    double max_mm);

}  // namespace sim::surface

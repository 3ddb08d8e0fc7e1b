#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/import/place.hpp"

namespace sim {

/// Replaces a row of points by few arcs and lines from its first point to its last one. Each
/// element starts and ends at points of the row, and passes through one point between them. It is
/// as long as possible within the tolerance of the chords between the points, and it turns by at
/// most half a turn. Consecutive elements need not have the same tangent where they meet.
///
/// Time: n log n for n points.
/// @param places at least two points, of which neighbours differ
/// @param tolerance_mm above 0
/// @return the vertex at which each element begins, with its bulge, and finally the end of the row
[[nodiscard]] std::vector<ContourVertex> arcs_along(const std::vector<drawing::Place>& places,
                                                    double tolerance_mm);

}  // namespace sim

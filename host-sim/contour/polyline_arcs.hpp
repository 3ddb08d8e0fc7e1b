#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/import/place.hpp"

namespace sim {

/// Replaces a row of places by few arcs and lines from its first place to its last one. Each goes
/// from place to place, through one of those between, and is as long as it can be within the
/// tolerance of the chords between places; it turns by half a turn at most. Elements meet with
/// tangents that differ by no more than the places allow.
///
/// Time: n log n for n places.
/// @param places two at least, of which neighbours differ
/// @param tolerance_mm above 0
/// @return where each element begins with its bulge, then the end
[[nodiscard]] std::vector<ContourVertex> arcs_along(const std::vector<drawing::Place>& places,
                                                    double tolerance_mm);

}  // namespace sim

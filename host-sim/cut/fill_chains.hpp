#pragma once

#include <vector>

#include "host-sim/cut/fill_rests.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Closed rows of one level: all at the same distance from the edge of an area.
using FillRows = std::vector<std::vector<Stroke>>;

/// Returns paths along all rows and rests of an area, from the inside outwards. From each row the
/// beam stays on to the nearest point of the next row outside, one interval away. If several paths
/// arrive at one row, the path whose beginning is farthest away continues along the row. The other
/// paths end at the row. A path of these that began nearby is driven as a detour from the row,
/// which starts with the beam off. A spur is driven from its corner outwards, and back to the
/// corner with the beam off.
/// @param rows rows of each level, the outermost level first; adjacent levels are one interval
/// apart
[[nodiscard]] std::vector<std::vector<Stroke>> fill_chains(std::vector<FillRows> rows,
                                                           const std::vector<FillRest>& rests,
                                                           double interval_mm);

}  // namespace sim::cut

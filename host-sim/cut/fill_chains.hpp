#pragma once

#include <vector>

#include "host-sim/cut/fill_rests.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Closed rows at one distance from the edge of an area.
using FillRows = std::vector<std::vector<Stroke>>;

/// Returns paths along all rows and rests, from the inside outwards. From each row the beam stays
/// on to the nearest point of the next row outside it, one interval away. Several paths may arrive
/// at one row. The path whose beginning is farthest away continues along the row. Paths that begin
/// nearby are detours from the row, which start with the beam off. The others end there. A spur is
/// driven from its corner, and back with the beam off.
/// @param rows by level, the outermost rows first; the rows of each level are one interval from
/// those of the previous level
[[nodiscard]] std::vector<std::vector<Stroke>> fill_chains(std::vector<FillRows> rows,
                                                           const std::vector<FillRest>& rests,
                                                           double interval_mm);

}  // namespace sim::cut

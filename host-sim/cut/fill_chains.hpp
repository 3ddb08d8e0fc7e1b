#pragma once

#include <vector>

#include "host-sim/cut/fill_rests.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Closed rows at one distance from the edge of an area.
using FillRows = std::vector<std::vector<Stroke>>;

/// Returns paths along all rows and rests, from the inside outwards. From each row the beam stays
/// on to the nearest place of the row before it, one interval away. Of several paths that arrive at
/// a row the one that begins farthest off goes on along it; those that begin near are detours from
/// it, to which the beam is off; others end there. A spur is driven from its corner and back with
/// the beam off.
/// @param rows by level, the outermost ones first; each is one interval from those before
[[nodiscard]] std::vector<std::vector<Stroke>> fill_chains(std::vector<FillRows> rows,
                                                           const std::vector<FillRest>& rests,
                                                           double interval_mm);

}  // namespace sim::cut

#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Splits contours into connected areas. Each area is an outline with the holes in it.
/// Throws NoPocketPath where a hole lies in no outline.
[[nodiscard]] std::vector<Contour> areas_of(const Contour& contours);

/// Returns an order of paths with short rapids. The order is a tour from X0 Y0 through all paths
/// and back; rapids lead from the last point of a path to the first point of the next. The result
/// is the same on every machine.
/// @pre no path is empty
[[nodiscard]] std::vector<std::size_t> short_order(const std::vector<PathRows>& paths);

}  // namespace sim::pocket

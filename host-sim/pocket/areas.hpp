#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Splits contours into connected areas. Each area is an outline with the holes in it. Throws
/// NoPocketPath if a hole is outside of all outlines.
[[nodiscard]] std::vector<Contour> areas_of(const Contour& contours);

/// Returns an order of the paths that keeps the rapids short. The order is a tour from X0 Y0
/// through all paths and back. Rapids lead from the last point of a path to the first point of the
/// next path. The result is the same on every computer.
/// @pre no path is empty
[[nodiscard]] std::vector<std::size_t> short_order(const std::vector<PathRows>& paths);

}  // namespace sim::pocket

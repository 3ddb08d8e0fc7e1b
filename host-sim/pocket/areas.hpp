#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Splits contours into connected areas, each an outline and the holes in it.
/// Throws NoPocketPath where a hole lies in no outline.
[[nodiscard]] std::vector<Contour> areas_of(const Contour& contours);

/// Returns an order of paths with short rapids: a tour from X0 Y0 through all of them and back,
/// from the last point of each to the first of the next. It is the same on every machine.
/// @pre no path is empty
[[nodiscard]] std::vector<std::size_t> short_order(const std::vector<PathRows>& paths);

}  // namespace sim::pocket

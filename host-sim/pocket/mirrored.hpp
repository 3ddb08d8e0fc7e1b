#pragma once

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Returns contours with the sign of Y changed. Material on the left of a loop stays on the left of
/// the mirrored loop.
[[nodiscard]] Contour mirrored(const Contour& contour);

/// Changes the sign of Y of all points and arcs of a path.
void mirror(PathRows& path);

}  // namespace sim::pocket

#pragma once

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Returns contours with the sign of Y changed. Material on the left of a loop stays on its left.
[[nodiscard]] Contour mirrored(const Contour& contour);

/// Changes the sign of Y in a path.
void mirror(PathRows& path);

}  // namespace sim::pocket

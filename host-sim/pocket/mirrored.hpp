#pragma once

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Returns contours with Y turned round: what is on the left of a loop stays there.
[[nodiscard]] Contour mirrored(const Contour& contour);

/// Turns Y of a path round.
void mirror(PathRows& path);

}  // namespace sim::pocket

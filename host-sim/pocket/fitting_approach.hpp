#pragma once

#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/round_return.hpp"

namespace sim::pocket {

/// Returns an approach: a line from the point `from`, then an arc from the end of this line into
/// the cut `cut`. On both, the tool stays in the area. These radii of the arc are tried until one
/// fits: kTurnOfTool times the tool's radius, half of it, a quarter and so on. Returns none where
/// no arc fits.
[[nodiscard]] Approach fitting_approach(const cnc::WideVec2& from,
                                        const Pose& cut,
                                        const OwnedArea& area,
                                        double tool_radius_mm);

}  // namespace sim::pocket

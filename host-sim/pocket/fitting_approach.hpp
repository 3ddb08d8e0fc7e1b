#pragma once

#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/round_return.hpp"

namespace sim::pocket {

/// Returns an approach: a line from a point, and an arc from this line into a cut, on which the
/// tool stays in the area. The arc is the widest that fits of kTurnOfTool, half of it, a quarter
/// and so on. Returns none where no arc fits.
[[nodiscard]] Approach fitting_approach(const cnc::WideVec2& from,
                                        const Pose& cut,
                                        const OwnedArea& area,
                                        double tool_radius_mm);

}  // namespace sim::pocket

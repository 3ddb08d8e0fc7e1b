#pragma once

#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/round_return.hpp"

namespace sim::pocket {

/// Returns a line from a place and an arc from it into a cut, on which the tool stays in the area:
/// the widest arc of kTurnOfTool, half of it, a quarter and so on. None where there is no room.
[[nodiscard]] Approach fitting_approach(const cnc::WideVec2& from,
                                        const Pose& cut,
                                        const OwnedArea& area,
                                        double tool_radius_mm);

}  // namespace sim::pocket

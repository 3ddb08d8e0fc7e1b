#pragma once

#include <vector>

#include "host-sim/pocket/depth_writer.hpp"
#include "planner/pocket/area_distance.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// Cuts along lines from the tool's place, and turns from each into the next in an arc where the
/// area has room for it: the lines follow its axis, so that their corners are flat.
/// @param way  the tool's place first; no two neighbours the same; the tool fits along all lines
void pass_lines(DepthWriter& writer,
                const std::vector<cnc::WideVec2>& way,
                const cnc::pocket::AreaDistance& area,
                double tool_radius_mm);

/// Cuts a disc from its centre, at which the tool has just arrived: by a half circle out to its
/// circle, and around it, both to the left and with one tangent.
void pass_disc(DepthWriter& writer, const cnc::pocket::ToolCircle& disc);

}  // namespace sim::pocket

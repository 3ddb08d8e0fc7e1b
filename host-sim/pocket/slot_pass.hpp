#pragma once

#include <vector>

#include "host-sim/pocket/depth_writer.hpp"
#include "planner/pocket/area_distance.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// Cuts along lines from the tool's position. The tool turns from each line into the next by an
/// arc, if the arc fits into the area. The lines follow the medial axis of the area, so their
/// corners are flat.
/// @param way  the tool's position, then the corners; neighbouring points differ; the tool fits
/// along all lines
void pass_lines(DepthWriter& writer,
                const std::vector<cnc::WideVec2>& way,
                const cnc::pocket::AreaDistance& area,
                double tool_radius_mm);

/// Cuts a disc from its centre, which is the tool's position: by a half circle out to the disc's
/// circle, then around this circle. Both turn left and join with one tangent.
void pass_disc(DepthWriter& writer, const cnc::pocket::ToolCircle& disc);

}  // namespace sim::pocket

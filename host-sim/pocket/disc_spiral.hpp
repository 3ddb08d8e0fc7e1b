#pragma once

#include "host-sim/pocket/axis_course.hpp"
#include "host-sim/pocket/depth_writer.hpp"

namespace sim::pocket {

/// Widens a cleared disc by half circles. Each half circle is as much wider than the previous one
/// as the engagement allows. Then goes once around on the last circle.
/// @param circle  the last circle. The tool has cleared a disc by going around the centre of this
/// circle. It is at a point of that motion, offset from the centre along X.
void open_by_spiral(const cnc::pocket::ToolCircle& circle,
                    const StepLimits& limits,
                    DepthWriter& writer);

}  // namespace sim::pocket

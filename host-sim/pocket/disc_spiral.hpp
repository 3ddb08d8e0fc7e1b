#pragma once

#include "host-sim/pocket/axis_course.hpp"
#include "host-sim/pocket/depth_writer.hpp"

namespace sim::pocket {

/// Widens a cleared disc by half circles, each of them as much wider than the one before it as the
/// engagement allows, and goes once around on the last circle.
/// @param circle  the last one; the tool has cleared a disc around its centre and stands on the
///   circle of that, beside the centre in X
void open_by_spiral(const cnc::pocket::ToolCircle& circle,
                    const StepLimits& limits,
                    DepthWriter& writer);

}  // namespace sim::pocket

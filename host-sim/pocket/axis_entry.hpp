#pragma once

#include <vector>

#include "host-sim/pocket/adaptive_path.hpp"
#include "host-sim/pocket/depth_writer.hpp"
#include "planner/pocket/area_distance.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// Returns whether a tool fits on a straight line from one point to another.
/// @pre the line does not leave the area
[[nodiscard]] bool fits_in_line(const cnc::WideVec2& from,
                                const cnc::WideVec2& to,
                                const cnc::pocket::AreaDistance& area,
                                double tool_radius_mm);

/// Returns the length of a polyline through the points of `way`, mm.
[[nodiscard]] double way_length(const std::vector<cnc::WideVec2>& way);

/// Returns the first part of a polyline along which a tool fits on straight lines from point to
/// point, at most as long as `longest_mm`. The result always contains the first point.
/// @param way  at least one point, in the area
[[nodiscard]] std::vector<cnc::WideVec2> fitting_way(const std::vector<cnc::WideVec2>& way,
                                                     const cnc::pocket::AreaDistance& area,
                                                     double tool_radius_mm,
                                                     double longest_mm);

/// Begins a row that descends into full stock to the writer's floor, within a circle on which the
/// tool may move. It descends by a helix of half turns. Where no helix fits, and for
/// EntryKind::kRamp, it descends by a ramp forth and back along `way`, or straight down at the
/// centre. Then it goes around at the bottom, on the circle or on a smaller circle within it.
///
/// Throws NoPocketPath where neither a helix nor a ramp fits.
/// @param way  points from the centre on; the tool fits on the straight lines between them
void enter_stock(const cnc::pocket::ToolCircle& circle,
                 const std::vector<cnc::WideVec2>& way,
                 const AdaptiveOptions& options,
                 DepthWriter& writer);

}  // namespace sim::pocket

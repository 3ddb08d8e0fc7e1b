#pragma once

#include <vector>

#include "host-sim/pocket/adaptive_path.hpp"
#include "host-sim/pocket/depth_writer.hpp"
#include "planner/pocket/area_distance.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// Returns whether a tool fits everywhere on a straight line from one point to another.
/// @pre the line does not leave the area
[[nodiscard]] bool fits_in_line(const cnc::WideVec2& from,
                                const cnc::WideVec2& to,
                                const cnc::pocket::AreaDistance& area,
                                double tool_radius_mm);

/// Returns the length of the polyline through the points of `way`, mm.
[[nodiscard]] double way_length(const std::vector<cnc::WideVec2>& way);

/// Returns the first part of the polyline `way` along which a tool fits, at most `longest_mm` long.
/// The result always contains the first point.
/// @param way  at least one point; all points are in the area
[[nodiscard]] std::vector<cnc::WideVec2> fitting_way(const std::vector<cnc::WideVec2>& way,
                                                     const cnc::pocket::AreaDistance& area,
                                                     double tool_radius_mm,
                                                     double longest_mm);

/// Begins a row that descends into full stock to the writer's floor, within `circle`, in which the
/// tool's centre may move. The tool descends by a helix of half turns. Where no helix fits, and for
/// EntryKind::kRamp, it descends by a ramp forth and back along `way`. For EntryKind::kPlunge, it
/// plunges at the centre. At the bottom, the tool goes around once, on the circle or on a smaller
/// circle within it.
///
/// Throws NoPocketPath if neither a helix nor a ramp fits and the tool must not plunge.
/// @param way  points that begin at the centre; the tool fits on the straight lines between them
void enter_stock(const cnc::pocket::ToolCircle& circle,
                 const std::vector<cnc::WideVec2>& way,
                 const AdaptiveOptions& options,
                 DepthWriter& writer);

}  // namespace sim::pocket

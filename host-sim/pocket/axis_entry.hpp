#pragma once

#include <vector>

#include "host-sim/pocket/adaptive_path.hpp"
#include "host-sim/pocket/depth_writer.hpp"
#include "planner/pocket/area_distance.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// Returns whether a tool fits on a straight line from one place to another.
/// @pre the line does not leave the area
[[nodiscard]] bool fits_in_line(const cnc::WideVec2& from,
                                const cnc::WideVec2& to,
                                const cnc::pocket::AreaDistance& area,
                                double tool_radius_mm);

/// Returns the length of a way from place to place, mm.
[[nodiscard]] double way_length(const std::vector<cnc::WideVec2>& way);

/// Returns the first part of a way along which a tool fits from place to place in straight lines,
/// at most as long as `longest_mm`. It has its first place in any case.
/// @param way  one place at least, in the area
[[nodiscard]] std::vector<cnc::WideVec2> fitting_way(const std::vector<cnc::WideVec2>& way,
                                                     const cnc::pocket::AreaDistance& area,
                                                     double tool_radius_mm,
                                                     double longest_mm);

/// Begins a row that goes down into full stock to the writer's floor, in a circle on which the tool
/// may go: by a helix of half turns; where none fits and for EntryKind::kRamp, by a ramp forth and
/// back along the way; or straight down at the centre. Then it goes around at the bottom, on the
/// circle or on one within it.
///
/// Throws NoPocketPath where neither a helix nor a ramp fits.
/// @param way  places from the centre on along which the tool fits in straight lines
void enter_stock(const cnc::pocket::ToolCircle& circle,
                 const std::vector<cnc::WideVec2>& way,
                 const AdaptiveOptions& options,
                 DepthWriter& writer);

}  // namespace sim::pocket

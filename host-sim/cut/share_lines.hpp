#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Combines the cuts between two parts that are a kerf apart into one shared line. Such cuts run
/// next to each other in opposite directions, within the distance of their settings
/// (LayerSettings::common_line_mm). The later cut leaves out the line that the earlier cut makes.
/// Open cuts replace the later cut. They begin and end in the kerf of the earlier cut, come after
/// it, and have no leads and no overcut.
///
/// A shared line is at least two kerfs long, or it is the line of an edge that parts share; see
/// paths_along_edges(). If earlier cuts would leave nothing of a part's cut, this cut is ordered
/// before one of them. If that is not permitted, the shortest shared line of this cut is cut twice.
/// Arcs around a corner at which two shared lines meet are left out, because both lines reach the
/// corner.
/// @param unbegun one for each cut of the plan. Afterwards this list and the cuts of the plan
/// contain the open cuts, too, with new numbers, and `plan.shared` has the counts
/// @param ranks position of each cut in an order that keeps every precedence
void share_lines(CutPlan& plan,
                 std::vector<UnbegunCut>& unbegun,
                 const std::vector<std::size_t>& ranks);

/// Returns, for each cut in order, the closed loop that this cut frees, if other cuts made lines of
/// it. The last cut of a contour that shares lines frees the whole loop of the contour. The entry
/// of every other cut is null.
[[nodiscard]] std::vector<SharedLoop> loops_closed_by(const std::vector<Cut>& cuts);

}  // namespace sim::cut

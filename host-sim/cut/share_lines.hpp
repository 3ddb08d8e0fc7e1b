#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Lets the line between two parts that lie a kerf apart be cut once. Of two cuts that run side by
/// side, in opposite directions and within the distance of their settings
/// (LayerSettings::common_line_mm), the later one leaves out what the earlier one cuts: it becomes
/// open cuts, which begin and end in the kerf of the earlier one and come after it. They have no
/// leads and no overcut.
///
/// A shared line is at least two kerfs long, or that of an edge that parts share; see
/// paths_along_edges(). Where earlier cuts would leave nothing to a part it comes before one of
/// them; where it must not, its shortest shared line is cut twice. Arcs round a corner at which two
/// shared lines meet are left out: both lines reach it.
/// @param unbegun one for each cut of the plan; both rows have more cuts afterwards, numbered anew,
/// and counts are in `plan.shared`
/// @param ranks the place of each cut in an order in which no cut comes before those that it must
/// come after
void share_lines(CutPlan& plan,
                 std::vector<UnbegunCut>& unbegun,
                 const std::vector<std::size_t>& ranks);

/// Returns, for each cut in order, the closed row of strokes that it frees because it is the last
/// of the cuts that share lines with others: the whole loop of its contour; null of other cuts.
[[nodiscard]] std::vector<SharedLoop> loops_closed_by(const std::vector<Cut>& cuts);

}  // namespace sim::cut

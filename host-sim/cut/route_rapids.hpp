#pragma once

#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Rules by which rapids avoid freed areas.
struct AvoidanceRules {
  double margin_mm = 0.1;  ///< Distance added to half a kerf, above 0; in gaps the sum may be less.
  double lift_mm = 0.0;    ///< Height of Z for rapids without a path; 0: the machine has no Z.
};

/// Returns the strokes of a cut that go once around an area, without those before and after them;
/// none for an open line. Tabs are included. Corner loops are replaced by arcs.
[[nodiscard]] std::vector<Stroke> loop_of_cut(const Cut& cut);

/// Routes rapids around holes and parts that earlier cuts have freed: these may have fallen, or
/// tipped into the path of the head. Rapids keep half a kerf plus the margin from the cut around a
/// part, and from the edge of a hole. Parts with tabs are not free. A closed cut on its line frees
/// the material inside once nothing inside is left to cut. From the piece that was just cut, the
/// rapid leaves by the shortest path.
///
/// Sets `approach` and `lift_mm` of all cuts, `way_home` and `lift_home_mm`, and counts in
/// `safety`. A rapid without a path is lifted. If the machine cannot lift, it becomes a fault that
/// names both of its cuts.
void route_rapids(CutPlan& plan, const drawing::Drawing& drawn, const AvoidanceRules& rules);

}  // namespace sim::cut

#pragma once

#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Rules by which rapids avoid freed areas.
struct AvoidanceRules {
  /// Distance from areas in addition to half a kerf, above 0. In gaps, rapids may keep less than
  /// the sum of both distances.
  double margin_mm = 0.1;
  double lift_mm = 0.0;  ///< Height of Z for rapids without a path; 0: rapids are not lifted.
};

/// Returns the strokes of a cut that go once around an area, with its tabs, but without leads and
/// overcut. Arcs replace corner loops. Returns none for an open line.
[[nodiscard]] std::vector<Stroke> loop_of_cut(const Cut& cut);

/// Routes rapids around holes and parts that earlier cuts have freed, because these may have fallen
/// or tipped into the path of the head. Rapids keep half a kerf plus the margin from the cut around
/// a part, and from the edge of a hole. Parts with tabs are not freed. A closed cut on its line
/// frees the material inside it when all cuts inside it are done. A rapid leaves the piece that was
/// just cut by the shortest path.
///
/// Sets `approach` and `lift_mm` of all cuts, `way_home` and `lift_home_mm`. Counts the rapids in
/// `safety`. A rapid without a path is lifted. If the rules do not permit lifting, the rapid
/// becomes a fault that names both of its cuts.
void route_rapids(CutPlan& plan, const drawing::Drawing& drawn, const AvoidanceRules& rules);

}  // namespace sim::cut

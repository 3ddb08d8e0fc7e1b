#pragma once

#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// How rapids avoid what has been cut free.
struct AvoidanceRules {
  double margin_mm = 0.1;  ///< Added to half a kerf, above 0; gaps may leave less of both.
  double lift_mm = 0.0;    ///< Height of Z where there is no way; 0: the machine has none.
};

/// Returns the strokes of a cut that go once round an area, whatever comes before and after them;
/// none of an open line. Tabs are among them; corner loops are not, but arcs instead.
[[nodiscard]] std::vector<Stroke> loop_of_cut(const Cut& cut);

/// Leads rapids round holes and parts that earlier cuts have cut free: they may have fallen, or
/// tipped into the way of the head. Rapids keep half a kerf and the margin from the cut round a
/// part, and from the edge of a hole. Parts with tabs are not free. A closed cut on
/// its line frees what is inside when nothing in there is left to cut. From the piece that was just
/// cut, the rapid leaves by the shortest way.
///
/// Sets `approach` and `lift_mm` of all cuts, `way_home` and `lift_home_mm`, and counts in
/// `safety`. A rapid without a way is lifted, or else a fault that names both of its cuts.
void route_rapids(CutPlan& plan, const drawing::Drawing& drawn, const AvoidanceRules& rules);

}  // namespace sim::cut

#pragma once

#include "host-sim/pocket/axis_graph.hpp"

namespace sim::pocket {

/// Removes edges that are not real from all free ends, then whole branches that end freely and
/// whose discs reach less than `slack_mm` beyond the disc at their other end, as those of corners
/// that are nearly straight. Of a part of the graph that is one point then, as in a circle, its
/// widest node stays without edges.
void prune_branches(AxisGraph& graph, double slack_mm);

}  // namespace sim::pocket

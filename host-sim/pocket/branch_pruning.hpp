#pragma once

#include "host-sim/pocket/axis_graph.hpp"

namespace sim::pocket {

/// Removes edges that are not real from all free ends. Then removes each branch with a free end
/// whose discs reach less than `slack_mm` beyond the disc at the branch's other end; nearly
/// straight corners have such branches. If a part of the graph shrinks to one point, as in a
/// circle, its widest node is kept without edges.
void prune_branches(AxisGraph& graph, double slack_mm);

}  // namespace sim::pocket

#pragma once

#include "host-sim/pocket/axis_graph.hpp"

namespace sim::pocket {

/// Removes edges that are not real (AxisEdge::is_real), from each free end inwards. Then removes
/// short branches with a free end. A branch is short if its discs reach less than `slack_mm` beyond
/// the disc at the branch's other end; nearly straight corners have such branches. If a part of the
/// graph shrinks to one point, as in a circle, its widest node is kept without edges.
void prune_branches(AxisGraph& graph, double slack_mm);

}  // namespace sim::pocket

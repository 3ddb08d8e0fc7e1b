#pragma once

#include <string>

#include "host-sim/cut/edge_check.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// Appends to a picture of cuts how far the edges of the parts are off: the drawn edges in
/// colours, the worst places with their figures, and what the colours mean, at `key_y_px`.
void add_edges(std::string& out,
               const cut::EdgeFigures& figures,
               const View& view,
               double key_y_px);

}  // namespace sim

#pragma once

#include <string>

#include "host-sim/cut/edge_check.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// Appends the deviations of the edges of parts to a picture of cuts: the drawn edges in colours,
/// the worst points with their figures, and a key of the colours at `key_y_px`.
void add_edges(std::string& out,
               const cut::EdgeFigures& figures,
               const View& view,
               double key_y_px);

}  // namespace sim

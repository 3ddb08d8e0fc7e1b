#pragma once

#include <string>

#include "host-sim/cut/edge_check.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim {

/// SVG document of a drawing and how it is cut: the parts, the band that the beam burns in the
/// width of the kerf, its middle, leads and overcuts, tabs, rapids, and where cuts begin.
/// @param edges how far the edges are off, where that was measured; else null
[[nodiscard]] std::string draw_cuts(const drawing::Drawing& drawn,
                                    const cut::CutPlan& plan,
                                    const std::string& title,
                                    const cut::EdgeFigures* edges = nullptr);

}  // namespace sim

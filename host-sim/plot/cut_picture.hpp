#pragma once

#include <string>

#include "host-sim/plot/cut_layers.hpp"

namespace sim {

/// SVG document of a drawing and how it is cut: the parts, the band that the beam burns in the
/// width of the kerf, its middle, leads and overcuts, tabs, rapids with their direction, where cuts
/// begin with their numbers, and where the sheet is warm from pierces shortly before.
/// @param edges how far the edges are off, where that was measured; else null
[[nodiscard]] std::string draw_cuts(const CutScene& scene,
                                    const std::string& title,
                                    const cut::EdgeFigures* edges = nullptr);

}  // namespace sim

#pragma once

#include <string>

#include "host-sim/plot/cut_layers.hpp"

namespace sim {

/// Returns an SVG document that shows a drawing and how it is cut. The picture contains the parts,
/// the band that the beam burns (as wide as the kerf), the middle of the band, leads and overcuts,
/// tabs, rapids with their directions, the numbers of the cuts at their beginnings, and the areas
/// that recent pierces have warmed.
/// @param edges deviations of the edges; null if they were not measured
[[nodiscard]] std::string draw_cuts(const CutScene& scene,
                                    const std::string& title,
                                    const cut::EdgeFigures* edges = nullptr);

}  // namespace sim

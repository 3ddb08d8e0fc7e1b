#pragma once

#include <string>

#include "host-sim/plot/cut_layers.hpp"

namespace sim {

/// Returns an SVG document of a drawing and of the way it is cut. It shows the parts, the band that
/// the beam burns (as wide as the kerf), the middle of the band, leads and overcuts, tabs, rapids
/// with their direction, the numbers of the cuts where they begin, and the areas that recent
/// pierces have warmed.
/// @param edges deviations of the edges if they were measured; otherwise null
[[nodiscard]] std::string draw_cuts(const CutScene& scene,
                                    const std::string& title,
                                    const cut::EdgeFigures* edges = nullptr);

}  // namespace sim

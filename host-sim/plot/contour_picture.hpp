#pragma once

#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Contours as an SVG document: the input in grey, its area filled, and each of
/// the offsets in a colour of its own, over a grid. Arcs are drawn as arcs.
[[nodiscard]] std::string draw_contours(const Contour& input,
                                        const std::vector<Contour>& offsets,
                                        const std::string& title);

}  // namespace sim

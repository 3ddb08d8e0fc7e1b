#pragma once

#include <string>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/stock/surface_comparison.hpp"

namespace sim {

/// Returns the map of a carved stock's distances from its surface as an SVG document: the plan, red
/// where the stock is cut into, blue where it is left, with grid, scale in mm, and the worst places
/// marked and listed. The plan is an image within the document.
/// @param facts a line below the title; may be empty
/// Throws std::runtime_error naming `file` if the plan cannot be drawn.
[[nodiscard]] std::string draw_deviation(const std::string& file,
                                         const stock::SurfaceComparison& comparison,
                                         const std::string& title,
                                         const std::string& facts);

/// Returns the colour of a distance as a share of the scale: from dark red at -1 through white to
/// dark blue at 1, held constant beyond.
[[nodiscard]] Colour deviation_colour(double share);

}  // namespace sim

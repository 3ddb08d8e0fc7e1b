#pragma once

#include <string>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/stock/surface_comparison.hpp"

namespace sim {

/// Returns an SVG document with a map of the distances between a carved stock and its surface. The
/// plan is red where the tool cut below the surface, and blue where material is left above it. It
/// has a grid, a scale in mm, and marks at the worst points, which a list repeats. The plan is an
/// image within the document. Throws std::runtime_error, with the name `file`, if the plan cannot
/// be drawn.
/// @param facts text of the line below the title; may be empty
[[nodiscard]] std::string draw_deviation(const std::string& file,
                                         const stock::SurfaceComparison& comparison,
                                         const std::string& title,
                                         const std::string& facts);

/// Returns the colour of a distance as a share of the scale: from dark red at -1 through white to
/// dark blue at 1. The colour is constant below -1 and above 1.
[[nodiscard]] Colour deviation_colour(double share);

}  // namespace sim

#pragma once

#include <string>

#include "host-sim/import/drawing.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// Returns an SVG document of the contours that were read from a drawing. It shows the material
/// (outer contours filled, holes empty), open contours as dashed lines, the number of each contour,
/// and a ring at each fault that has a position. A drawing without contours gives a valid picture
/// without content.
[[nodiscard]] std::string draw_contours(const drawing::Drawing& drawn);

/// Appends a contour as path data of SVG. Curves are approximated to a tenth of a pixel.
void add_outline(std::string& data, const drawing::DrawnContour& contour, const View& view);

}  // namespace sim

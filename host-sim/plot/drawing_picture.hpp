#pragma once

#include <string>

#include "host-sim/import/drawing.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// What was read of a drawing, as an SVG document: the material that is left (outer
/// contours filled, holes not), open contours dashed, the number of each contour, a ring at each
/// fault that has a place. A drawing without contours is a valid picture of nothing.
[[nodiscard]] std::string draw_contours(const drawing::Drawing& drawn);

/// A contour as path data of SVG, its curves to a tenth of a pixel.
void add_outline(std::string& data, const drawing::DrawnContour& contour, const View& view);

}  // namespace sim

#pragma once

#include <vector>

#include "host-sim/cut/recipe.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Changes open contours of layers that are cut at an offset to cuts on the line. Users draw living
/// hinges, score lines and slits in this way. An open contour has no inside, and therefore no side
/// for the kerf. Contours that may be meant as closed (DrawnContour::is_doubtful) stay among the
/// faults of the drawing.
/// @param layers plan of each layer of the drawing
/// @param recipes receives plans for these contours
/// @return a warning for each layer with such contours, which gives their number
[[nodiscard]] std::vector<drawing::Fault> cut_open_on_line(const drawing::Drawing& drawn,
                                                           const std::vector<LayerPlan>& layers,
                                                           Recipes& recipes);

}  // namespace sim::cut

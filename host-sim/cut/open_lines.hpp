#pragma once

#include <vector>

#include "host-sim/cut/recipe.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Lets open contours of layers that are cut beside their lines be cut on them, as living hinges,
/// score lines and slits are drawn: they have no inside, so no side for the kerf. Contours that may
/// be meant closed (DrawnContour::is_doubtful) are left to the drawing's faults.
/// @param layers one for each layer of the drawing
/// @param recipes receives plans for these contours
/// @return a warning for each layer that has such contours, with their number
[[nodiscard]] std::vector<drawing::Fault> cut_open_on_line(const drawing::Drawing& drawn,
                                                           const std::vector<LayerPlan>& layers,
                                                           Recipes& recipes);

}  // namespace sim::cut

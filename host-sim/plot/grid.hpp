#pragma once

#include <string>
#include <string_view>

#include "host-sim/plot/view.hpp"

namespace sim {

/// Appends a light grid over the box of the view, with labels in mm on the left and below.
/// @param axes names of both axes and their unit, which are written at the end of the lower side
void add_grid(std::string& out, const View& view, std::string_view axes = "X, Y in mm");

}  // namespace sim

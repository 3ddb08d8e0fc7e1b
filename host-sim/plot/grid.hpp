#pragma once

#include <string>

#include "host-sim/plot/view.hpp"

namespace sim {

/// Appends a light grid over the box of the view, labelled in mm on the left and below.
void add_grid(std::string& out, const View& view);

}  // namespace sim

#pragma once

#include <string>

#include "host-sim/plot/space/axonometry.hpp"

namespace sim {

/// Appends, with light grid lines, the sides of a box that are behind all content: the floor and
/// the two walls that are far from the viewer.
void add_back_sides(std::string& out, const Axonometry& axonometry, const SpaceBox& box);

/// Appends the scales of X, Y and Z in mm along outer edges of a box.
void add_space_axes(std::string& out, const Axonometry& axonometry, const SpaceBox& box);

}  // namespace sim

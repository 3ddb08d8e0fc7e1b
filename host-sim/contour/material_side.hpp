#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Turns loops round where needed, so that material is on the left of each: the
/// outermost run counter-clockwise, holes in them clockwise, islands in those
/// counter-clockwise, and so on. Nothing else changes. For loops that do not cross.
void put_material_left(Contour& contour);

}  // namespace sim

#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Reverses loops where needed, so that material is on the left of each loop. The outermost loops
/// run counter-clockwise, the holes in them clockwise, the islands in those holes
/// counter-clockwise, and so on. Nothing else changes.
/// @pre no loops cross
void put_material_left(Contour& contour);

}  // namespace sim

#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Returns loops that do not touch themselves. A loop that touches itself at vertices is split into
/// several loops, which touch each other at these vertices. A hole that touches its outline at a
/// corner, for example, becomes a separate loop. Consecutive lines in the same direction become one
/// line.
/// @pre no loop crosses itself
[[nodiscard]] Contour simple_loops(const cnc::contour::ContourView<double>& loops);

}  // namespace sim

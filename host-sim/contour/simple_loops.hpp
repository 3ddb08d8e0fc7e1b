#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Returns loops that touch themselves in vertices as several loops that do not, which touch each
/// other there: a hole that meets its outline in a corner is a loop of its own. Lines that go
/// straight on become one.
/// @pre no loop crosses itself
[[nodiscard]] Contour simple_loops(const cnc::contour::ContourView<double>& loops);

}  // namespace sim

#pragma once

#include <optional>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Returns the outlines of the material that loops enclose, with the material on their left. A
/// point is in the material if the sum of the winding numbers of the loops around it is positive.
/// Edges with material on both sides are left out.
/// @return nothing if rounding keeps the outlines from closing
[[nodiscard]] std::optional<Contour> filled_loops(const cnc::contour::ContourView<double>& loops);

}  // namespace sim

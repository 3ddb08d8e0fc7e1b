#pragma once

#include <optional>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Returns the outlines of the material that loops enclose, with the material on their left. A
/// point is in the material if the loops turn more often to the left than to the right around it.
/// Edges with material on both sides are removed.
/// @return nothing if the outlines do not close, which is a fault of rounding
[[nodiscard]] std::optional<Contour> filled_loops(const cnc::contour::ContourView<double>& loops);

}  // namespace sim

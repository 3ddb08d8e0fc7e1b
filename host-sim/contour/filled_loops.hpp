#pragma once

#include <optional>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Returns the outlines of the material that loops with material on their left enclose: where they
/// turn more often to the left than to the right. Edges that loops share with the material of
/// both sides are gone.
/// @return nothing where the outlines do not close, which is a fault of rounding
[[nodiscard]] std::optional<Contour> filled_loops(const cnc::contour::ContourView<double>& loops);

}  // namespace sim

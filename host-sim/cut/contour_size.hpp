#pragma once

#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Returns the diameter of the smallest circle around all places, mm; 0 for one place or none.
/// Source: Welzl 1991, in its iterative form. The radius is right to a few roundings.
[[nodiscard]] double enclosing_diameter(std::vector<drawing::Place> places);

/// Returns the diameter of a circle, mm; of any other contour that of the smallest circle around
/// it, within 0.002 mm.
[[nodiscard]] double diameter_of(const drawing::DrawnContour& contour);

}  // namespace sim::cut

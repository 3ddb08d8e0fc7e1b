#pragma once

#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Returns the diameter of the smallest circle around all points, mm; 0 for fewer than two points.
/// Source: Welzl 1991, in its iterative form. The error of the radius is a few roundings.
[[nodiscard]] double enclosing_diameter(std::vector<drawing::Place> places);

/// Returns the diameter of a contour, mm. For a circle, this is its exact diameter. For any other
/// contour, it is the diameter of the smallest circle around it, within 0.002 mm.
[[nodiscard]] double diameter_of(const drawing::DrawnContour& contour);

}  // namespace sim::cut

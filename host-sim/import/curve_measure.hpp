#pragma once

#include <span>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim::drawing {

/// Greatest distance between a shape and its chords in all comparisons of contours, mm.
inline constexpr double kChordToleranceMm = 0.001;

/// Appends points along the shape, without its start but with its end. The chords between the
/// points are within about `tolerance_mm` of the shape. A span gets at most 65,536 points.
void flatten(const Shape& shape, double tolerance_mm, std::vector<Place>& into);

/// Returns points along a row of shapes, from the start of the first shape to the end of the last
/// one.
[[nodiscard]] std::vector<Place> outline_of(std::span<const Shape> shapes, double tolerance_mm);

/// Returns the length of a shape, mm. The length is exact for lines and arcs. For other shapes it
/// is computed by quadrature with a relative error of about 10⁻⁶.
[[nodiscard]] double length_of(const Shape& shape);

/// Returns ½ ∮ (x dy − y dx) along the shape, with `from` as the origin, in mm². The sum over a
/// closed row of shapes is the enclosed area, positive if the row turns left.
[[nodiscard]] double swept_area(const Shape& shape, const Place& from);

}  // namespace sim::drawing

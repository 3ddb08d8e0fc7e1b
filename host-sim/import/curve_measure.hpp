#pragma once

#include <span>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim::drawing {

/// Greatest distance of chords from their shape wherever contours are compared, mm.
inline constexpr double kChordToleranceMm = 0.001;

/// Appends points along the shape, without its start but with its end. The chords between them
/// leave the shape by at most about `tolerance_mm`. A span gets at most 65,536 points.
void flatten(const Shape& shape, double tolerance_mm, std::vector<Place>& into);

/// Returns points along a row of shapes, including the start of the first shape.
[[nodiscard]] std::vector<Place> outline_of(std::span<const Shape> shapes, double tolerance_mm);

/// Returns the length, in mm. It is exact for lines and arcs. For other shapes it is a quadrature
/// with a relative error of about 10⁻⁶.
[[nodiscard]] double length_of(const Shape& shape);

/// Returns ½ ∮ (x dy − y dx) along the shape, with `from` as the origin, in mm². The sum over a
/// closed row of shapes is the enclosed area, positive if the row turns left.
[[nodiscard]] double swept_area(const Shape& shape, const Place& from);

}  // namespace sim::drawing

#pragma once

#include <span>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim::drawing {

/// Chords of a shape are within this of it wherever contours are compared, mm.
inline constexpr double kChordToleranceMm = 0.001;

/// Appends places along the shape, without its start and with its end, whose
/// chords leave it by no more than about `tolerance_mm`; at most 65,536 a span.
void flatten(const Shape& shape, double tolerance_mm, std::vector<Place>& into);

/// The places of a whole row of shapes, the first start included.
[[nodiscard]] std::vector<Place> outline_of(std::span<const Shape> shapes, double tolerance_mm);

/// mm. Exact for lines and arcs, else a quadrature good to about 10⁻⁶ of it.
[[nodiscard]] double length_of(const Shape& shape);

/// ½ ∮ (x dy − y dx) along the shape, seen from `from`, mm²: summed over a closed
/// row it is its area, positive where it turns left.
[[nodiscard]] double swept_area(const Shape& shape, const Place& from);

}  // namespace sim::drawing

#pragma once

#include <optional>
#include <vector>

#include "host-sim/import/curve.hpp"
#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/dxf_shapes.hpp"

namespace sim::drawing {

/// Returns the curves of a SPLINE, or of the spline in a HELIX. Uses its control points; without
/// them, a spline through its fit points. The degree is 1 to kHighestDegree.
///
/// A knot that is repeated degree + 1 times divides the spline. Each part is a curve of its own,
/// and the drawing alone decides whether the parts meet.
/// @pre no bad_number()
[[nodiscard]] DxfShapes spline_shapes(const DxfEntity& entity);

/// Returns the cubic spline through points, with continuous curvature and with chord lengths as
/// parameters. It is straight at an end without a tangent.
/// @pre two points or more, no two neighbours equal
[[nodiscard]] std::vector<Shape> fitted_spline(const std::vector<Place>& places,
                                               const std::optional<Place>& start_tangent,
                                               const std::optional<Place>& end_tangent);

/// Returns the closed cubic spline through points, with continuous curvature at all of them.
/// @pre three points or more, no two neighbours equal, the last not equal to the first
[[nodiscard]] std::vector<Shape> closed_spline(const std::vector<Place>& places);

}  // namespace sim::drawing

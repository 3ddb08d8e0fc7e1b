#pragma once

#include <optional>
#include <vector>

#include "host-sim/import/curve.hpp"
#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/dxf_shapes.hpp"

namespace sim::drawing {

/// Returns the curves of a SPLINE, or of the spline in a HELIX. Uses the control points of the
/// spline. If there are none, returns a spline through its fit points. The degree must be 1 to
/// kHighestDegree.
///
/// A knot that occurs degree + 1 times divides the spline into separate curves. Whether their ends
/// meet depends on the control points alone.
/// @pre no bad_number()
[[nodiscard]] DxfShapes spline_shapes(const DxfEntity& entity);

/// Returns the cubic spline through points, with continuous curvature and with chord lengths as
/// parameters. At an end for which no tangent is given, the curvature is 0.
/// @pre two points or more, no two neighbours equal
[[nodiscard]] std::vector<Shape> fitted_spline(const std::vector<Place>& places,
                                               const std::optional<Place>& start_tangent,
                                               const std::optional<Place>& end_tangent);

/// Returns the closed cubic spline through points, with continuous curvature at all of them.
/// @pre three points or more, no two neighbours equal, the last not equal to the first
[[nodiscard]] std::vector<Shape> closed_spline(const std::vector<Place>& places);

}  // namespace sim::drawing

#pragma once

#include <optional>
#include <vector>

#include "host-sim/import/curve.hpp"
#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/dxf_shapes.hpp"

namespace sim::drawing {

/// Returns the curves of a SPLINE, or of the spline in a HELIX: by its control points, else
/// through its fit points. Degree 1 to kHighestDegree.
///
/// A knot that is repeated degree + 1 times parts the spline: each part is a curve of its own, and
/// they meet where the drawing makes them meet. @pre no bad_number()
[[nodiscard]] DxfShapes spline_shapes(const DxfEntity& entity);

/// The cubic spline through places with curvature continuous, chord lengths as
/// parameters and, where no tangents are given, straight at its ends.
/// @pre two places or more, no two neighbours the same
[[nodiscard]] std::vector<Shape> fitted_spline(const std::vector<Place>& places,
                                               const std::optional<Place>& start_tangent,
                                               const std::optional<Place>& end_tangent);

/// The closed cubic spline through places, with curvature continuous all round.
/// @pre three places or more, no two neighbours the same, the last not the first
[[nodiscard]] std::vector<Shape> closed_spline(const std::vector<Place>& places);

}  // namespace sim::drawing

#pragma once

#include <vector>

#include "host-sim/import/curve.hpp"
#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/dxf_shapes.hpp"

namespace sim::drawing {

/// A corner of a polyline, and the bulge of the edge that begins at the corner.
struct BulgeVertex {
  Place place;
  double bulge = 0.0;
};

/// Returns the edges of a polyline, except edges without length.
[[nodiscard]] std::vector<Shape> bulge_edges(const std::vector<BulgeVertex>& vertices, bool closed);

/// Returns the edges of an LWPOLYLINE.
/// @pre no bad_number()
[[nodiscard]] DxfShapes light_polyline(const DxfEntity& entity);

/// Returns the edges of a POLYLINE, whose corners are separate entities.
/// @pre no bad_number() in the POLYLINE or its vertices
[[nodiscard]] DxfShapes old_polyline(const DxfEntity& entity,
                                     const std::vector<DxfEntity>& vertices);

/// Returns the outline of a 3DFACE, SOLID or TRACE, without the edges that a 3DFACE marks as
/// hidden.
/// @pre no bad_number()
[[nodiscard]] DxfShapes face_outline(const DxfEntity& entity);

}  // namespace sim::drawing

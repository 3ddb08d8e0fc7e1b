#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/import/curve.hpp"
#include "host-sim/import/dxf_group.hpp"

namespace sim::drawing {

/// A corner of a polyline with the bulge of the edge that follows.
struct BulgeVertex {
  Place place;
  double bulge = 0.0;
};

/// The edges of a polyline; those without length are left out.
[[nodiscard]] std::vector<Shape> bulge_edges(const std::vector<BulgeVertex>& vertices, bool closed);

/// From the plane of an entity to that of the drawing: as it is, or seen from
/// behind. Nothing where it is tilted.
[[nodiscard]] std::optional<Transform> dxf_plane(const DxfEntity& entity);

/// LINE, ARC, CIRCLE, LWPOLYLINE, ELLIPSE, SPLINE.
[[nodiscard]] bool is_dxf_shape(std::string_view type);

struct DxfShapes {
  std::vector<Shape> shapes;
  std::string wrong;  ///< Empty, or why there are none.
};

/// The copies of an INSERT, in the units and axes of its own. Those without a spacing would be
/// drawn one on the other: one of them is, and the others are counted.
struct InsertArray {
  std::size_t columns;
  std::size_t rows;
  Place spacing;         ///< From column to column, and from row to row.
  std::size_t left_out;  ///< Copies that lie on those that are drawn.

  /// Where copy `index` of columns · rows is, row after row.
  [[nodiscard]] Place step(std::size_t index) const {
    const std::size_t row = index / columns;
    return {static_cast<double>(index % columns) * spacing.x(),
            static_cast<double>(row) * spacing.y()};
  }
};
[[nodiscard]] InsertArray insert_array(const DxfEntity& entity);

/// In the units of the drawing. @pre is_dxf_shape(entity.type), no bad_number()
[[nodiscard]] DxfShapes dxf_shapes(const DxfEntity& entity);

/// The cubic spline through places with curvature continuous, chord lengths as
/// parameters and, where no tangents are given, straight at its ends.
/// @pre two places or more
[[nodiscard]] std::vector<Shape> fitted_spline(const std::vector<Place>& places,
                                               const std::optional<Place>& start_tangent,
                                               const std::optional<Place>& end_tangent);

}  // namespace sim::drawing

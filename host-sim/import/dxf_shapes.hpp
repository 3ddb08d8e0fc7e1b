#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/curve.hpp"
#include "host-sim/import/dxf_group.hpp"

namespace sim::drawing {

inline constexpr const char* kDxfUpright =
    "its plane is tilted so far that it is a line from above";
inline constexpr const char* kDxfSeenFromAbove = "is tilted: it is drawn as it is seen from above";

/// Heights that differ by less are one.
inline constexpr double kFlatEnoughUnits = 1.0e-6;

/// From the plane of an entity to that of the drawing.
struct DxfPlane {
  Transform to_plan{};
  bool is_tilted = false;  ///< Neither as it is nor seen from behind: circles become ellipses.
};

/// Returns the plane of the entity's extrusion, `elevation` along its normal. Nothing where it
/// stands upright.
[[nodiscard]] std::optional<DxfPlane> dxf_plane(const DxfEntity& entity, double elevation);

/// LINE, ARC, CIRCLE, LWPOLYLINE, ELLIPSE, SPLINE, HELIX, 3DFACE, SOLID, TRACE.
[[nodiscard]] bool is_dxf_shape(std::string_view type);

struct DxfShapes {
  std::vector<Shape> shapes{};
  std::string wrong{};               ///< Empty, or why there are none.
  std::vector<std::string> notes{};  ///< How they were read, to follow the entity's type.
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

}  // namespace sim::drawing

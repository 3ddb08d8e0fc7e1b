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

/// Heights that differ by less count as equal.
inline constexpr double kFlatEnoughUnits = 1.0e-6;

/// The map from the plane of an entity to the plane of the drawing.
struct DxfPlane {
  Transform to_plan{};
  /// The entity's plane is not parallel to that of the drawing: circles become ellipses.
  bool is_tilted = false;
};

/// Returns the plane of the entity's extrusion, at the distance `elevation` along its normal.
/// Returns nothing if the plane is upright.
[[nodiscard]] std::optional<DxfPlane> dxf_plane(const DxfEntity& entity, double elevation);

/// Returns whether a type is one of LINE, ARC, CIRCLE, LWPOLYLINE, ELLIPSE, SPLINE, HELIX, 3DFACE,
/// SOLID and TRACE.
[[nodiscard]] bool is_dxf_shape(std::string_view type);

struct DxfShapes {
  std::vector<Shape> shapes{};
  std::string wrong{};  ///< Reason why there are no shapes; empty if there are.
  /// Notes on how the shapes were read, as text after the entity's type.
  std::vector<std::string> notes{};
};

/// The copies of an INSERT, in its own units and axes. Copies without a spacing would lie on each
/// other: one of them is drawn, and the others are counted.
struct InsertArray {
  std::size_t columns;
  std::size_t rows;
  Place spacing;         ///< Distance from column to column (x), and from row to row (y).
  std::size_t left_out;  ///< Number of copies that lie on copies that are drawn.

  /// Returns the offset of copy `index` of columns · rows, counted row after row.
  [[nodiscard]] Place step(std::size_t index) const {
    const std::size_t row = index / columns;
    return {static_cast<double>(index % columns) * spacing.x(),
            static_cast<double>(row) * spacing.y()};
  }
};
[[nodiscard]] InsertArray insert_array(const DxfEntity& entity);

/// Returns the shapes of an entity, in the units of the drawing.
/// @pre is_dxf_shape(entity.type), no bad_number()
[[nodiscard]] DxfShapes dxf_shapes(const DxfEntity& entity);

}  // namespace sim::drawing

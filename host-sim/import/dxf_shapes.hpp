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
    "its plane is upright, so that it is only a line as seen from above";
inline constexpr const char* kDxfSeenFromAbove = "is tilted: it is drawn as seen from above";

/// Greatest difference of heights that count as equal, in units of the drawing.
inline constexpr double kFlatEnoughUnits = 1.0e-6;

/// The map from the plane of an entity to the plane of the drawing.
struct DxfPlane {
  Transform to_plan{};
  /// True if the plane of the entity is not parallel to the plane of the drawing, so that circles
  /// become ellipses.
  bool is_tilted = false;
};

/// Returns the plane of an entity, at the distance `elevation` from the origin along its normal
/// vector (the extrusion direction). Returns nothing if the plane is upright.
[[nodiscard]] std::optional<DxfPlane> dxf_plane(const DxfEntity& entity, double elevation);

/// Returns whether a type is one of LINE, ARC, CIRCLE, LWPOLYLINE, ELLIPSE, SPLINE, HELIX, 3DFACE,
/// SOLID and TRACE.
[[nodiscard]] bool is_dxf_shape(std::string_view type);

struct DxfShapes {
  std::vector<Shape> shapes{};
  std::string wrong{};  ///< Reason why there are no shapes; empty if there are shapes.
  /// Texts of notes about the reading of the shapes; each text follows the type of the entity.
  std::vector<std::string> notes{};
};

/// The array of copies of an INSERT, in the units and axes of the INSERT. Copies without a spacing
/// would lie on each other. Only one of them is drawn, and the others are counted.
struct InsertArray {
  std::size_t columns;
  std::size_t rows;
  Place spacing;  ///< Distance between neighbouring columns (x) and between neighbouring rows (y).
  /// Number of copies that are not drawn, because they lie on copies that are drawn.
  std::size_t left_out;

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

#include "host-sim/import/dxf_shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include "host-sim/import/dxf_polyline.hpp"
#include "host-sim/import/dxf_splines.hpp"

namespace sim::drawing {
namespace {

using Space = Eigen::Vector3d;

constexpr double kRadiansInDegree = kFullTurn / 360.0;
// Bounds on the components of a normal vector of length 1. If its horizontal component is at most
// kTilt, the plane of the entity is level. If its vertical component is less than kUprightShare,
// the plane is upright.
constexpr double kTilt = 1.0e-6;
constexpr double kUprightShare = 1.0e-3;

/// Returns the point in space whose coordinates have the codes `code`, `code` + 10 and `code` + 20.
Space space_of(const DxfEntity& entity, int code, double otherwise) {
  const Place place = entity.place(code);
  return {place.x(), place.y(), entity.number(code + 20, otherwise)};
}

/// Returns the normal vector of an entity, with length 1; nothing if the data of the entity define
/// no direction.
std::optional<Space> normal_of(const DxfEntity& entity) {
  const bool is_given = entity.number(210) || entity.number(220);
  const Space normal = space_of(entity, 210, is_given ? 0.0 : 1.0);
  const double length = normal.norm();
  if (!(length > 0.0) || !std::isfinite(length)) return {};
  return Space{normal / length};
}

/// Returns the angle from `from` to `to`, counter-clockwise, in radians: above 0 and at most a full
/// turn.
double turn_between(double from, double to) {
  double sweep = std::fmod(to - from, kFullTurn);
  // Files give a full turn as 0 to 360 or as 0 to 6.283185. The second number is rounded.
  constexpr double kRounded = 1.0e-9;
  if (sweep <= kRounded) sweep += kFullTurn;
  return std::abs(sweep - kFullTurn) <= 1.0e-6 ? kFullTurn : sweep;
}

DxfShapes on_plane(const DxfPlane& plane, const Shape& shape) {
  DxfShapes drawn;
  drawn.shapes.push_back(transformed(shape, plane.to_plan));
  if (plane.is_tilted) drawn.notes.emplace_back(kDxfSeenFromAbove);
  return drawn;
}

DxfShapes circle_shapes(const DxfEntity& entity) {
  const double radius = entity.number(40, 0.0);
  if (!(radius > 0.0)) return {.wrong = "its radius is not above 0"};
  const auto plane = dxf_plane(entity, entity.number(30, 0.0));
  if (!plane) return {.wrong = kDxfUpright};
  double from = 0.0;
  double sweep = kFullTurn;
  if (entity.type == "ARC") {
    from = entity.number(50, 0.0) * kRadiansInDegree;
    sweep = turn_between(from, entity.number(51, 360.0) * kRadiansInDegree);
  }
  return on_plane(*plane, arc_of(entity.place(10), radius, from, sweep));
}

/// Returns the shapes of an ELLIPSE. The centre and the axes of the ellipse are in coordinates of
/// the drawing. The normal vector determines the direction of the minor axis.
DxfShapes ellipse_shapes(const DxfEntity& entity) {
  const auto plane = dxf_plane(entity, 0.0);
  if (!plane) return {.wrong = kDxfUpright};
  const double ratio = entity.number(40, 0.0);
  const Space major = space_of(entity, 11, 0.0);
  if (!(ratio > 0.0) || !(major.norm() > 0.0)) return {.wrong = "its axes are not above 0"};
  Space minor{-major.y() * ratio, major.x() * ratio, 0.0};
  if (plane->to_plan.determinant() < 0.0) minor = -minor;
  if (plane->is_tilted) minor = normal_of(entity)->cross(major) * ratio;
  const double from = entity.number(41, 0.0);
  const double sweep = turn_between(from, entity.number(42, kFullTurn));
  const Ellipse ellipse{entity.place(10), major.head<2>(), minor.head<2>(), from, from + sweep};
  return on_plane({{}, plane->is_tilted}, ellipse);
}

DxfShapes line_shapes(const DxfEntity& entity) {
  DxfShapes drawn{.shapes{Line{entity.place(10), entity.place(11)}}};
  const double rise = entity.number(31, 0.0) - entity.number(30, 0.0);
  if (std::abs(rise) > kFlatEnoughUnits) drawn.notes.emplace_back(kDxfSeenFromAbove);
  return drawn;
}

}  // namespace

std::optional<DxfPlane> dxf_plane(const DxfEntity& entity, double elevation) {
  const auto normal = normal_of(entity);
  if (!normal || std::abs(normal->z()) < kUprightShare) return {};
  if (normal->head<2>().norm() <= kTilt) {
    return DxfPlane{normal->z() > 0.0 ? Transform{} : scaled_by(-1.0, 1.0)};
  }
  // This is the arbitrary axis algorithm of the DXF reference.
  constexpr double kNearTheAxis = 1.0 / 64.0;
  const bool is_near = std::abs(normal->x()) < kNearTheAxis && std::abs(normal->y()) < kNearTheAxis;
  const Space helper = is_near ? Space{0.0, 1.0, 0.0} : Space{0.0, 0.0, 1.0};
  const Space across = helper.cross(*normal).normalized();
  const Space up = normal->cross(across);
  return DxfPlane{
      {.x_axis = across.head<2>(), .y_axis = up.head<2>(), .origin = normal->head<2>() * elevation},
      true};
}

InsertArray insert_array(const DxfEntity& entity) {
  InsertArray array{.columns = static_cast<std::size_t>(std::max(1, entity.whole(70, 1))),
                    .rows = static_cast<std::size_t>(std::max(1, entity.whole(71, 1))),
                    .spacing = {entity.number(44, 0.0), entity.number(45, 0.0)},
                    .left_out = 0};
  const std::size_t asked = array.columns * array.rows;
  if (array.spacing.x() == 0.0) array.columns = 1;
  if (array.spacing.y() == 0.0) array.rows = 1;
  array.left_out = asked - array.columns * array.rows;
  return array;
}

bool is_dxf_shape(std::string_view type) {
  static constexpr std::array<std::string_view, 10> kTypes{"LINE",
                                                           "ARC",
                                                           "CIRCLE",
                                                           "LWPOLYLINE",
                                                           "ELLIPSE",
                                                           "SPLINE",
                                                           "HELIX",
                                                           "3DFACE",
                                                           "SOLID",
                                                           "TRACE"};
  return std::ranges::find(kTypes, type) != kTypes.end();
}

DxfShapes dxf_shapes(const DxfEntity& entity) {
  if (entity.type == "LINE") return line_shapes(entity);
  if (entity.type == "ELLIPSE") return ellipse_shapes(entity);
  if (entity.type == "SPLINE" || entity.type == "HELIX") return spline_shapes(entity);
  if (entity.type == "LWPOLYLINE") return light_polyline(entity);
  if (entity.type == "ARC" || entity.type == "CIRCLE") return circle_shapes(entity);
  return face_outline(entity);
}

}  // namespace sim::drawing

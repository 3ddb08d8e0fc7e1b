#include "host-sim/import/dxf_shapes.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace sim::drawing {
namespace {

constexpr double kRadiansInDegree = kFullTurn / 360.0;
constexpr int kClosedFlag = 1;
constexpr const char* kTilted = "it lies in a tilted plane";

/// A turn from `from` to `to`, counter-clockwise and above 0.
double turn_between(double from, double to) {
  double sweep = std::fmod(to - from, kFullTurn);
  // Files write a whole turn as 0 to 360, or to 6.283185: with what was rounded off.
  constexpr double kRounded = 1.0e-9;
  if (sweep <= kRounded) sweep += kFullTurn;
  return std::abs(sweep - kFullTurn) <= 1.0e-6 ? kFullTurn : sweep;
}

DxfShapes circle_shapes(const DxfEntity& entity) {
  const double radius = entity.number(40, 0.0);
  if (!(radius > 0.0)) return {{}, "its radius is not above 0"};
  const auto plane = dxf_plane(entity);
  if (!plane) return {{}, kTilted};
  double from = 0.0;
  double sweep = kFullTurn;
  if (entity.type == "ARC") {
    from = entity.number(50, 0.0) * kRadiansInDegree;
    sweep = turn_between(from, entity.number(51, 360.0) * kRadiansInDegree);
  }
  return {{transformed(arc_of(entity.place(10), radius, from, sweep), *plane)}, {}};
}

/// Its axes are in the drawing's plane; only the turn's sense follows the normal.
DxfShapes ellipse_shapes(const DxfEntity& entity) {
  const auto plane = dxf_plane(entity);
  if (!plane) return {{}, kTilted};
  const double ratio = entity.number(40, 0.0);
  const Place major = entity.place(11);
  if (!(ratio > 0.0) || !(major.norm() > 0.0)) return {{}, "its axes are not above 0"};
  const double side = plane->determinant();
  const Place minor{-major.y() * ratio * side, major.x() * ratio * side};
  const double from = entity.number(41, 0.0);
  const double sweep = turn_between(from, entity.number(42, kFullTurn));
  const Ellipse ellipse{entity.place(10), major, minor, from, from + sweep};
  return {{transformed(ellipse, {})}, {}};
}

DxfShapes polyline_shapes(const DxfEntity& entity) {
  const auto plane = dxf_plane(entity);
  if (!plane) return {{}, kTilted};
  std::vector<BulgeVertex> vertices;
  for (const DxfGroup& group : entity.groups) {
    const double value = dxf_number(group.value).value_or(0.0);
    if (group.code == 10) vertices.push_back({{value, 0.0}});
    if (group.code == 20 && !vertices.empty()) vertices.back().place.y() = value;
    if (group.code == 42 && !vertices.empty()) vertices.back().bulge = value;
  }
  std::vector<Shape> shapes = bulge_edges(vertices, (entity.whole(70, 0) & kClosedFlag) != 0);
  for (Shape& shape : shapes) shape = transformed(shape, *plane);
  return {std::move(shapes), {}};
}

std::optional<Place> tangent(const DxfEntity& entity, int code) {
  const Place way = entity.place(code);
  if (!entity.number(code) || !(way.norm() > 0.0)) return {};
  return way;
}

DxfShapes spline_shapes(const DxfEntity& entity) {
  std::vector<Place> points = entity.places(10);
  if (!points.empty()) {
    const int degree = entity.whole(71, 3);
    if (degree < 1) return {{}, "its degree is below 1"};
    auto curve = nurbs(static_cast<std::size_t>(degree),
                       std::move(points),
                       entity.numbers(41),
                       entity.numbers(40));
    if (!curve) return {{}, "its degree, points, weights and knots make no spline"};
    return {{*std::move(curve)}, {}};
  }
  std::vector<Place> through = entity.places(11);
  const bool closed = (entity.whole(70, 0) & kClosedFlag) != 0;
  if (closed && !through.empty()) through.push_back(through.front());
  // The ranges of this library do not compile with Clang 14.
  through.erase(std::unique(through.begin(), through.end()), through.end());
  if (through.size() < 2) return {{}, "it has neither control points nor fit points"};
  return {fitted_spline(through, tangent(entity, 12), tangent(entity, 13)), {}};
}

}  // namespace

std::vector<Shape> bulge_edges(const std::vector<BulgeVertex>& vertices, bool closed) {
  std::vector<Shape> shapes;
  const std::size_t count = vertices.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const BulgeVertex& from = vertices[i];
    const BulgeVertex& to = vertices[(i + 1) % count];
    if (from.place == to.place) continue;
    shapes.push_back(bulge_edge(from.place, to.place, from.bulge));
  }
  return shapes;
}

std::optional<Transform> dxf_plane(const DxfEntity& entity) {
  const Place across = entity.place(210);
  const double up = entity.number(230, 1.0);
  constexpr double kTilt = 1.0e-6;
  if (!(std::abs(up) > 0.0) || across.norm() > kTilt * std::abs(up)) return {};
  return up > 0.0 ? Transform{} : scaled_by(-1.0, 1.0);
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
  static constexpr std::array<std::string_view, 6> kTypes{
      "LINE", "ARC", "CIRCLE", "LWPOLYLINE", "ELLIPSE", "SPLINE"};
  return std::ranges::find(kTypes, type) != kTypes.end();
}

DxfShapes dxf_shapes(const DxfEntity& entity) {
  if (entity.type == "LINE") return {{Line{entity.place(10), entity.place(11)}}, {}};
  if (entity.type == "ELLIPSE") return ellipse_shapes(entity);
  if (entity.type == "SPLINE") return spline_shapes(entity);
  if (entity.type == "LWPOLYLINE") return polyline_shapes(entity);
  return circle_shapes(entity);
}

std::vector<Shape> fitted_spline(const std::vector<Place>& places,
                                 const std::optional<Place>& start_tangent,
                                 const std::optional<Place>& end_tangent) {
  const std::size_t last = places.size() - 1;
  std::vector<double> spans(last);
  for (std::size_t i = 0; i < last; ++i) spans[i] = distance(places[i], places[i + 1]);
  // Derivatives by the chord length, from a system of three diagonals (Thomas).
  std::vector<Place> slopes(last + 1);
  std::vector<double> upper(last + 1, 0.0);
  const auto chord = [&](std::size_t i) { return Place{(places[i + 1] - places[i]) / spans[i]}; };
  if (start_tangent) {
    slopes[0] = *start_tangent / start_tangent->norm();
  } else {
    upper[0] = 0.5;
    slopes[0] = 1.5 * chord(0);
  }
  for (std::size_t i = 1; i < last; ++i) {
    const double low = 1.0 / spans[i - 1];
    const double high = 1.0 / spans[i];
    const double pivot = 2.0 * (low + high) - low * upper[i - 1];
    upper[i] = high / pivot;
    slopes[i] = (3.0 * (low * chord(i - 1) + high * chord(i)) - low * slopes[i - 1]) / pivot;
  }
  if (end_tangent) {
    slopes[last] = *end_tangent / end_tangent->norm();
  } else {
    slopes[last] = (3.0 * chord(last - 1) - slopes[last - 1]) / (2.0 - upper[last - 1]);
  }
  for (std::size_t i = last; i-- > 0;) slopes[i] -= upper[i] * slopes[i + 1];
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < last; ++i) {
    const double third = spans[i] / 3.0;
    shapes.emplace_back(Bezier{{places[i],
                                places[i] + slopes[i] * third,
                                places[i + 1] - slopes[i + 1] * third,
                                places[i + 1]}});
  }
  return shapes;
}

}  // namespace sim::drawing

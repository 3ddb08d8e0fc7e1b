#include "host-sim/import/dxf_polyline.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace sim::drawing {
namespace {

constexpr int kClosedPolyline = 1;
constexpr const char* kWide = "has a width: the middle of its line is drawn";

bool has_width(const DxfEntity& entity) {
  return std::ranges::any_of(entity.groups, [](const DxfGroup& group) {
    const bool is_width = group.code == 40 || group.code == 41 || group.code == 43;
    return is_width && dxf_number(group.value).value_or(0.0) > 0.0;
  });
}

DxfShapes edges_on(const DxfPlane& plane, const std::vector<BulgeVertex>& corners, bool closed) {
  DxfShapes drawn{.shapes = bulge_edges(corners, closed)};
  for (Shape& shape : drawn.shapes) shape = transformed(shape, plane.to_plan);
  if (plane.is_tilted) drawn.notes.emplace_back(kDxfSeenFromAbove);
  return drawn;
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

DxfShapes light_polyline(const DxfEntity& entity) {
  const auto plane = dxf_plane(entity, entity.number(38, 0.0));
  if (!plane) return {.wrong = kDxfUpright};
  std::vector<BulgeVertex> vertices;
  for (const DxfGroup& group : entity.groups) {
    const double value = dxf_number(group.value).value_or(0.0);
    if (group.code == 10) vertices.push_back({{value, 0.0}});
    if (group.code == 20 && !vertices.empty()) vertices.back().place.y() = value;
    if (group.code == 42 && !vertices.empty()) vertices.back().bulge = value;
  }
  DxfShapes drawn = edges_on(*plane, vertices, (entity.whole(70, 0) & kClosedPolyline) != 0);
  if (has_width(entity)) drawn.notes.emplace_back(kWide);
  return drawn;
}

DxfShapes old_polyline(const DxfEntity& entity, const std::vector<DxfEntity>& vertices) {
  constexpr int kInSpace = 8;
  constexpr int kMesh = 16 | 64;
  constexpr int kFrame = 16;
  const int flags = entity.whole(70, 0);
  if ((flags & kMesh) != 0) return {.wrong = "it is a mesh"};
  const bool in_space = (flags & kInSpace) != 0;
  const auto plane = in_space ? DxfPlane{} : dxf_plane(entity, entity.number(30, 0.0));
  if (!plane) return {.wrong = kDxfUpright};
  std::vector<BulgeVertex> corners;
  bool is_wide = has_width(entity);
  double lowest = 0.0;
  double highest = 0.0;
  for (const DxfEntity& vertex : vertices) {
    if ((vertex.whole(70, 0) & kFrame) != 0) continue;
    const double height = vertex.number(30, 0.0);
    lowest = corners.empty() ? height : std::min(lowest, height);
    highest = corners.empty() ? height : std::max(highest, height);
    corners.push_back({vertex.place(10), vertex.number(42, 0.0)});
    is_wide = is_wide || has_width(vertex);
  }
  DxfShapes drawn = edges_on(*plane, corners, (flags & kClosedPolyline) != 0);
  if (is_wide) drawn.notes.emplace_back(kWide);
  if (in_space && highest - lowest > kFlatEnoughUnits) drawn.notes.emplace_back(kDxfSeenFromAbove);
  return drawn;
}

DxfShapes face_outline(const DxfEntity& entity) {
  const bool is_face = entity.type == "3DFACE";
  const auto plane = is_face ? DxfPlane{} : dxf_plane(entity, entity.number(30, 0.0));
  if (!plane) return {.wrong = kDxfUpright};
  std::array<Place, 4> corners{entity.place(10), entity.place(11), entity.place(12)};
  corners[3] = entity.number(13) ? entity.place(13) : corners[2];
  if (!is_face) std::swap(corners[2], corners[3]);
  const int hidden = is_face ? entity.whole(70, 0) : 0;
  DxfShapes drawn;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Place& to = corners[(i + 1) % corners.size()];
    if (corners[i] == to || (hidden >> i & 1) != 0) continue;
    drawn.shapes.emplace_back(transformed(Line{corners[i], to}, plane->to_plan));
  }
  bool is_level = !plane->is_tilted;
  for (const int code : {31, 32, 33}) {
    const double height = entity.number(code, entity.number(30, 0.0));
    is_level = is_level && std::abs(height - entity.number(30, 0.0)) <= kFlatEnoughUnits;
  }
  if (!is_level) drawn.notes.emplace_back(kDxfSeenFromAbove);
  return drawn;
}

}  // namespace sim::drawing

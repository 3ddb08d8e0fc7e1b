#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host-sim/surface/mesh_draft.hpp"
#include "host-sim/surface/mesh_orientation.hpp"
#include "host-sim/surface/refusal.hpp"

namespace sim::surface {
namespace {

constexpr auto kUnusedPoint = std::numeric_limits<std::uint32_t>::max();
/// A facet is degenerate if twice its area, divided by the square of an edge, is at most this
/// ratio. For a facet without area, the ratio is below this limit even after rounding of the
/// coordinates.
constexpr double kDegenerateShare = 1.0e-12;

void require_indices(const MeshDraft& draft) {
  for (std::size_t i = 0; i < draft.mesh.facets.size(); ++i) {
    for (const std::uint32_t corner : draft.mesh.facets[i]) {
      if (corner < draft.mesh.points.size()) continue;
      refuse(draft.name,
             0,
             fmt::format("facet {} has point {}, but the last point is {}",
                         draft.number(i),
                         corner,
                         static_cast<std::int64_t>(draft.mesh.points.size()) - 1),
             "export the mesh again");
    }
  }
}

void take_unit(MeshDraft& draft, double unit_mm) {
  for (Eigen::Vector3d& point : draft.mesh.points) point *= unit_mm;
  for (std::size_t i = 0; i < draft.mesh.facets.size(); ++i) {
    for (const std::uint32_t corner : draft.mesh.facets[i]) {
      const Eigen::Vector3d& point = draft.mesh.points[corner];
      if (point.cwiseAbs().maxCoeff() <= kFarthestMm && !point.hasNaN()) continue;
      if (!point.allFinite()) {
        refuse(draft.name,
               0,
               fmt::format("facet {} has a coordinate that is not finite", draft.number(i)),
               "export the mesh again without such points");
      }
      refuse(draft.name,
             0,
             fmt::format("facet {} lies beyond {:g} m", draft.number(i), kFarthestMm / 1000.0),
             "check the unit, or move the origin to the part");
    }
  }
}

bool is_degenerate(const Mesh& mesh, const std::array<std::uint32_t, 3>& facet) {
  const Eigen::Vector3d u = mesh.points[facet[1]] - mesh.points[facet[0]];
  const Eigen::Vector3d v = mesh.points[facet[2]] - mesh.points[facet[0]];
  const double edge = std::max(u.squaredNorm(), v.squaredNorm());
  const double x = u.y() * v.z() - u.z() * v.y();
  const double y = u.z() * v.x() - u.x() * v.z();
  const double z = u.x() * v.y() - u.y() * v.x();
  return !(std::sqrt(x * x + y * y + z * z) > kDegenerateShare * edge);
}

void drop_degenerate(MeshDraft& draft) {
  auto& facets = draft.mesh.facets;
  std::size_t first = 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (is_degenerate(draft.mesh, facets[i])) {
      if (first == 0) first = draft.number(i);
    } else {
      facets[kept++] = facets[i];
    }
  }
  const std::size_t dropped = facets.size() - kept;
  facets.resize(kept);
  if (kept == 0) {
    refuse(draft.name, 0, "has no facet with an area", "export a mesh of triangles or polygons");
  }
  if (dropped == 0) return;
  draft.notes.push_back(
      fmt::format("{}: {} facets without area are left out, the first is facet {}",
                  draft.name,
                  dropped,
                  first));
}

/// Removes points that belong to no facet. The remaining points keep their order.
void drop_unused(MeshDraft& draft) {
  Mesh& mesh = draft.mesh;
  std::vector<std::uint32_t> number(mesh.points.size(), kUnusedPoint);
  for (const auto& facet : mesh.facets) {
    for (const std::uint32_t corner : facet) number[corner] = 0;
  }
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == kUnusedPoint) continue;
    mesh.points[kept] = mesh.points[i];
    number[i] = kept++;
  }
  const std::size_t dropped = mesh.points.size() - kept;
  if (dropped == 0) return;
  mesh.points.resize(kept);
  for (auto& facet : mesh.facets) {
    for (std::uint32_t& corner : facet) corner = number[corner];
  }
  draft.notes.push_back(
      fmt::format("{}: {} points that belong to no facet are left out", draft.name, dropped));
}

}  // namespace

SurfaceInput finished_mesh(MeshDraft draft, const ReadOptions& options) {
  require_indices(draft);
  take_unit(draft, options.unit_mm);
  drop_degenerate(draft);
  drop_unused(draft);
  if (is_inside_out(draft.mesh)) {
    for (auto& facet : draft.mesh.facets) std::swap(facet[1], facet[2]);
    draft.notes.push_back(draft.name + ": the mesh was inside out, so its facets are flipped");
  }
  return {.grid = {}, .mesh = std::move(draft.mesh), .notes = std::move(draft.notes)};
}

}  // namespace sim::surface

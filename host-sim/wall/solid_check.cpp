#include "host-sim/wall/solid_check.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include "host-sim/surface/refusal.hpp"

namespace sim::wall {
namespace {

/// An edge of a facet, from the point with the smaller number to the point with the greater number.
struct EdgeUse {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  int direction = 0;  ///< 1, or -1 if the facet's border passes the edge in the other direction.

  [[nodiscard]] bool is_same_edge(const EdgeUse& other) const {
    return low == other.low && high == other.high;
  }
};

std::vector<EdgeUse> edges_of(const surface::Mesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.facets.size());
  for (const auto& facet : mesh.facets) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = facet[i];
      const std::uint32_t to = facet[(i + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
  }
  std::ranges::sort(uses, {}, [](const EdgeUse& use) { return std::tuple{use.low, use.high}; });
  return uses;
}

std::string text_of(const Eigen::Vector3d& point) {
  return fmt::format("{:g} {:g} {:g}", point.x(), point.y(), point.z());
}

/// Throws std::invalid_argument unless the facets face outwards and enclose a volume.
void require_inside(const surface::Mesh& mesh, const std::string& name) {
  const Eigen::Vector3d& origin = mesh.points.front();
  double six_volumes = 0.0;
  double size = 0.0;
  for (const auto& [a, b, c] : mesh.facets) {
    const Eigen::Vector3d across =
        (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    const double part = across.dot(mesh.points[a] - origin);
    six_volumes += part;
    size += std::abs(part);
  }
  // Ratio of the volume to the sum of its absolute terms, up to which the volume may result from
  // rounding and counts as 0.
  constexpr double kNoVolume = 1.0e-12;
  if (std::abs(six_volumes) <= kNoVolume * size) {
    surface::refuse(name, 0, "encloses no volume", "give a part that has a thickness");
  }
  if (six_volumes < 0.0) {
    surface::refuse(name, 0, "is inside out", "turn its facets outwards");
  }
}

}  // namespace

void require_solid(const surface::Mesh& mesh, const std::string& name) {
  const std::vector<EdgeUse> uses = edges_of(mesh);
  std::size_t open = 0;
  std::string first;
  for (auto use = uses.begin(); use != uses.end();) {
    const auto end =
        std::find_if(use, uses.end(), [&use](const EdgeUse& o) { return !o.is_same_edge(*use); });
    int sides = 0;
    for (auto i = use; i != end; ++i) sides += i->direction;
    if (sides != 0 && ++open == 1) {
      first = fmt::format("the edge from {} to {}",
                          text_of(mesh.points[use->low]),
                          text_of(mesh.points[use->high]));
    }
    use = end;
  }
  if (open == 0) return require_inside(mesh, name);
  surface::refuse(name,
                  0,
                  fmt::format("does not enclose a solid: {} has a facet on only one side{}",
                              first,
                              open == 1 ? "" : fmt::format(", and {} more", open - 1)),
                  "close the holes of the mesh and turn its facets outwards");
}

}  // namespace sim::wall

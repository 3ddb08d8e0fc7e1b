#include "host-sim/surface/tried_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_map>

namespace sim::surface {
namespace {

/// An edge, given by its first facet and the edge's number there, and the number of facets that
/// share it.
struct Side {
  std::uint32_t facet;
  std::uint8_t edge;
  std::uint8_t count;
};

std::uint64_t key_of(std::uint32_t one, std::uint32_t other) {
  return std::uint64_t{std::min(one, other)} << 32U | std::max(one, other);
}

std::uint8_t bit(std::uint8_t edge) { return static_cast<std::uint8_t>(1U << edge); }

const Eigen::Vector3d& corner(const Mesh& mesh, const Side& side, std::size_t number) {
  return mesh.points[mesh.facets[side.facet][(side.edge + number) % 3]];
}

/// Returns whether two facets are on different sides of their edge in plan, and neither facet is
/// below the plane of the other.
bool is_valley(const Mesh& mesh, const Side& one, const Side& other) {
  const Eigen::Vector3d& from = corner(mesh, one, 0);
  const Eigen::Vector3d along = corner(mesh, one, 1) - from;
  const Eigen::Vector3d first = corner(mesh, one, 2) - from;
  const Eigen::Vector3d second = corner(mesh, other, 2) - from;
  const double side = along.x() * first.y() - along.y() * first.x();
  const double far_side = along.x() * second.y() - along.y() * second.x();
  if (!(side * far_side < 0.0)) return false;
  const double above = along.cross(first).dot(second);
  return side > 0.0 ? above >= 0.0 : above <= 0.0;
}

}  // namespace

std::vector<std::uint8_t> tried_edges(const Mesh& mesh, bool tool_is_smooth) {
  std::vector<std::uint8_t> tried(mesh.facets.size(), 0);
  std::unordered_map<std::uint64_t, Side> seen;
  seen.reserve(2 * mesh.facets.size());
  for (std::uint32_t facet = 0; facet < mesh.facets.size(); ++facet) {
    for (std::uint8_t i = 0; i < 3; ++i) {
      const auto& corners = mesh.facets[facet];
      const Side here{facet, i, 1};
      const auto [place, is_first] =
          seen.try_emplace(key_of(corners[i], corners[(i + 1U) % 3]), here);
      Side& first = place->second;
      if (is_first) {
        tried[facet] |= bit(i);
      } else if (first.count == 1) {
        first.count = 2;
        const bool drops = tool_is_smooth && is_valley(mesh, first, here);
        if (drops) tried[first.facet] &= static_cast<std::uint8_t>(~bit(first.edge));
      } else {
        tried[first.facet] |= bit(first.edge);  // An edge that three facets share is always tested.
      }
    }
  }
  return tried;
}

}  // namespace sim::surface

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace sim::surface {

/// Triangles over shared points; lengths in mm.
struct Mesh {
  std::vector<Eigen::Vector3d> points;
  /// Indices of the three points of each facet. Seen from outside or above, the points are
  /// counter-clockwise, if the reader can determine the outside.
  std::vector<std::array<std::uint32_t, 3>> facets;
};

/// Returns the height of the highest point.
/// @pre the mesh has a point
[[nodiscard]] inline double top_of(const Mesh& mesh) {
  double top = mesh.points.front().z();
  for (const Eigen::Vector3d& point : mesh.points) top = std::max(top, point.z());
  return top;
}

}  // namespace sim::surface

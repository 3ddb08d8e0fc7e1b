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
  /// Indices of points, three for each facet. They are counter-clockwise seen from +Z if the reader
  /// can determine that.
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

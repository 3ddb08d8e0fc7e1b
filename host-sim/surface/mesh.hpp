#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace sim::surface {

/// Triangles over shared points; lengths in mm.
struct Mesh {
  std::vector<Eigen::Vector3d> points;
  /// Indices of points; counter-clockwise seen from +Z where the reader can know.
  std::vector<std::array<std::uint32_t, 3>> facets;
};

}  // namespace sim::surface

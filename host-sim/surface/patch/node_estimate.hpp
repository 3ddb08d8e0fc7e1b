#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// A point of the surface at the corner of patches, with its derivatives by row (u) and column (v).
struct Node {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_u = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_v = Eigen::Vector3d::Zero();
  Eigen::Vector3d twist = Eigen::Vector3d::Zero();
};

/// A point of the grid, and the distances in rows and columns up to which its neighbours are used.
struct NodeWindow {
  std::size_t row = 0;
  std::size_t column = 0;
  std::size_t rows = 1;
  std::size_t columns = 1;
};

/// Returns position and derivatives of a polynomial of degree 3 in each parameter that fits the
/// points in the window best, by least squares. At the grid's rim the window is moved inwards. With
/// a window of one row and one column the polynomial passes through the point.
/// @pre the grid has at least two rows and columns
[[nodiscard]] Node estimated_node(const PointGrid& grid, const NodeWindow& window);

}  // namespace sim::surface::patch

#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// A point of the surface at a corner of patches, with the derivatives by row (u) and column (v).
struct Node {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_u = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_v = Eigen::Vector3d::Zero();
  Eigen::Vector3d twist = Eigen::Vector3d::Zero();
};

/// A point of the grid, and the numbers of rows and columns on each side whose points are used for
/// an estimate.
struct NodeWindow {
  std::size_t row = 0;
  std::size_t column = 0;
  std::size_t rows = 1;
  std::size_t columns = 1;
};

/// Returns the position and derivatives of a surface at a point of the grid. The surface is a
/// least-squares fit to the points in the window, with a polynomial of degree 3 in each parameter.
/// At the grid's rim, the window is moved inwards. With a window of one row and one column, the
/// result has the position of the point itself.
/// @pre the grid has at least two rows and columns
[[nodiscard]] Node estimated_node(const PointGrid& grid, const NodeWindow& window);

}  // namespace sim::surface::patch

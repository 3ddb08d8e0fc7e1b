#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// A grid of points that form quadrilaterals, with rows of equal length. The points need not be
/// regular. Lengths are mm.
struct PointGrid {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Eigen::Vector3d> points;  ///< Points row by row.

  /// Returns the point of a row and a column, both counted from 0.
  /// @pre row < rows, column < columns
  [[nodiscard]] const Eigen::Vector3d& at(std::size_t row, std::size_t column) const;
};

/// Returns two triangles for each quadrilateral, divided by the diagonal from (row, column) to (row
/// + 1, column + 1). All triangles have the same order of corners. Seen from +Z, most of the area
/// of the triangles is counter-clockwise. Points keep their order.
[[nodiscard]] Mesh triangulated(const PointGrid& grid);

}  // namespace sim::surface

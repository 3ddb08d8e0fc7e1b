#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// A quadrilateral grid that need not be regular: rows of equal length; lengths in mm.
struct PointGrid {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Eigen::Vector3d> points;  ///< Row by row.

  /// Returns the point of a row and a column, both from 0.
  /// @pre row < rows, column < columns
  [[nodiscard]] const Eigen::Vector3d& at(std::size_t row, std::size_t column) const;
};

/// Returns two triangles for each quadrilateral, divided by the diagonal from (row, column) to
/// (row + 1, column + 1). They are counter-clockwise seen from +Z if most of the grid is so seen
/// from one side; points keep their order.
[[nodiscard]] Mesh triangulated(const PointGrid& grid);

}  // namespace sim::surface

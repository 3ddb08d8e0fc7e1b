#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "host-sim/surface/box_tree.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

using Triangle = std::array<Eigen::Vector3d, 3>;

/// Returns the square of the distance between a point and a triangle, mm². The triangle may have no
/// area.
[[nodiscard]] double square_distance(const Eigen::Vector3d& point, const Triangle& triangle);

/// Returns the square of the distance between `point` and the nearer of a quadrilateral's two
/// triangles, mm². The quadrilateral is between `row` and `column` and the next row and column.
[[nodiscard]] double square_distance_from(const PointGrid& grid,
                                          std::uint32_t row,
                                          std::uint32_t column,
                                          const Eigen::Vector3d& point);

/// Computes distances of points from the triangles of a grid. triangulated() describes the
/// triangles.
class GridDistance {
 public:
  /// @pre the grid has at least two rows and columns, and outlives this object
  explicit GridDistance(const PointGrid& grid);

  /// Returns the square of the distance between `point` and the nearest triangle of the grid, mm².
  /// @param known an upper bound: the square of the distance from any quadrilateral
  [[nodiscard]] double square_distance_from_all(const Eigen::Vector3d& point, double known) const;

 private:
  const PointGrid* grid_;
  BoxTree tree_;  ///< Bounding boxes of the quadrilaterals, row by row.
};

}  // namespace sim::surface::patch

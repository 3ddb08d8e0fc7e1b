#include "host-sim/surface/point_grid.hpp"

#include <cstdint>

namespace sim::surface {
namespace {

/// Returns the sum of the projected areas of all quadrilaterals, in mm². The sum is positive if,
/// seen from +Z, the direction of rising row numbers is counter-clockwise from the direction of
/// rising column numbers.
double projected_area(const PointGrid& grid) {
  double twice = 0.0;
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      const Eigen::Vector3d along = grid.at(row + 1, column + 1) - grid.at(row, column);
      const Eigen::Vector3d across = grid.at(row + 1, column) - grid.at(row, column + 1);
      twice += along.x() * across.y() - along.y() * across.x();
    }
  }
  return 0.5 * twice;
}

}  // namespace

const Eigen::Vector3d& PointGrid::at(std::size_t row, std::size_t column) const {
  return points[row * columns + column];
}

Mesh triangulated(const PointGrid& grid) {
  Mesh mesh{.points = grid.points, .facets = {}};
  if (grid.rows < 2 || grid.columns < 2) return mesh;
  const bool turned = projected_area(grid) < 0.0;
  mesh.facets.reserve(2 * (grid.rows - 1) * (grid.columns - 1));
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      const auto corner = static_cast<std::uint32_t>(row * grid.columns + column);
      const auto above = static_cast<std::uint32_t>(corner + grid.columns);
      if (turned) {
        mesh.facets.push_back({corner, above + 1, corner + 1});
        mesh.facets.push_back({corner, above, above + 1});
      } else {
        mesh.facets.push_back({corner, corner + 1, above + 1});
        mesh.facets.push_back({corner, above + 1, above});
      }
    }
  }
  return mesh;
}

}  // namespace sim::surface

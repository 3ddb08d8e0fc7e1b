#include "host-sim/surface/patch/grid_distance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

double square_from_segment(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
  const Vector3d along = to - from;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp(along.dot(point - from) / square, 0.0, 1.0) : 0.0;
  return (point - from - share * along).squaredNorm();
}

/// Returns the triangles of the quadrilateral whose first corner is (row, column).
std::array<Triangle, 2> triangles_of(const PointGrid& grid, std::size_t row, std::size_t column) {
  const Vector3d& first = grid.at(row, column);
  const Vector3d& last = grid.at(row + 1, column + 1);
  return {{{first, grid.at(row, column + 1), last}, {first, last, grid.at(row + 1, column)}}};
}

}  // namespace

double square_distance(const Vector3d& point, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector3d normal = (b - a).cross(c - a);
  const bool is_over = normal.dot((b - a).cross(point - a)) >= 0.0 &&
                       normal.dot((c - b).cross(point - b)) >= 0.0 &&
                       normal.dot((a - c).cross(point - c)) >= 0.0;
  const double square = normal.squaredNorm();
  if (is_over && square > 0.0) {
    const double height = normal.dot(point - a);
    return height * height / square;
  }
  return std::min({square_from_segment(point, a, b),
                   square_from_segment(point, b, c),
                   square_from_segment(point, c, a)});
}

double square_distance_from(const PointGrid& grid,
                            std::uint32_t row,
                            std::uint32_t column,
                            const Vector3d& point) {
  const std::array<Triangle, 2> triangles = triangles_of(grid, row, column);
  return std::min(square_distance(point, triangles[0]), square_distance(point, triangles[1]));
}

GridDistance::GridDistance(const PointGrid& grid) : grid_{&grid} {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve((grid.rows - 1) * (grid.columns - 1));
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      Eigen::AlignedBox3d box{grid.at(row, column)};
      box.extend(grid.at(row, column + 1));
      box.extend(grid.at(row + 1, column));
      box.extend(grid.at(row + 1, column + 1));
      boxes.push_back(box);
    }
  }
  tree_ = BoxTree{boxes};
}

double GridDistance::square_distance_from_all(const Vector3d& point, double known) const {
  double least = known;
  const auto width = static_cast<std::uint32_t>(grid_->columns - 1);
  tree_.visit_near(
      point,
      [&least] { return std::sqrt(least); },
      [&](std::uint32_t quadrilateral) {
        least = std::min(
            least,
            square_distance_from(*grid_, quadrilateral / width, quadrilateral % width, point));
      });
  return least;
}

}  // namespace sim::surface::patch

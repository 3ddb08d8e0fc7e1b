#include "host-sim/surface/grid_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host-sim/surface/median.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/surface/refusal.hpp"

namespace sim::surface {
namespace {

/// A step between points is a gap if its length exceeds the median length times this factor.
constexpr double kGapFactor = 4.0;
/// Greatest reversed area of a triangle that rounding may cause, relative to the square of its
/// longer edge.
constexpr double kFoldTolerance = 1.0e-9;

double cross_in_plan(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool turns_over(const Eigen::Vector3d& a,
                const Eigen::Vector3d& b,
                const Eigen::Vector3d& c,
                double sense) {
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = c - a;
  const double longest = std::max(u.head<2>().squaredNorm(), v.head<2>().squaredNorm());
  return sense * cross_in_plan(u, v) < -kFoldTolerance * longest;
}

void refuse_equal_neighbours(const GridDraft& grid) {
  FaultyPoints equal;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const bool left = i % grid.columns > 0 && grid.points[i] == grid.points[i - 1];
    const bool below = i >= grid.columns && grid.points[i] == grid.points[i - grid.columns];
    if (left || below) equal.add(i);
  }
  if (equal.count() == 0) return;
  refuse_points(grid,
                equal,
                fmt::format("{} points equal their neighbour", equal.count()),
                "keep only one of equal points");
}

/// Returns whether the row reverses its direction at the point after `column`.
bool runs_back(const GridDraft& grid, std::size_t row, std::size_t column) {
  if (column + 2 >= grid.columns) return false;
  const Eigen::Vector3d step = grid.at(row, column + 1) - grid.at(row, column);
  const Eigen::Vector3d next = grid.at(row, column + 2) - grid.at(row, column + 1);
  return step.head<2>().dot(next.head<2>()) < 0.0;
}

void refuse_folds(const GridDraft& grid) {
  const double area = projected_area(grid);
  if (area == 0.0) {
    refuse(grid.name, 0, "has no area as seen from above", "give X, Y and height in this order");
  }
  const double sense = area > 0.0 ? 1.0 : -1.0;
  FaultyPoints folds;
  bool back = false;
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      const Eigen::Vector3d& corner = grid.at(row, column);
      const Eigen::Vector3d& opposite = grid.at(row + 1, column + 1);
      if (turns_over(corner, grid.at(row, column + 1), opposite, sense) ||
          turns_over(corner, opposite, grid.at(row + 1, column), sense)) {
        if (folds.count() == 0) back = runs_back(grid, row, column);
        folds.add(row * grid.columns + column);
      }
    }
  }
  if (folds.count() == 0) return;
  refuse_points(grid,
                folds,
                fmt::format("{} quadrilaterals are flipped as seen from above{}, the first",
                            folds.count(),
                            back ? " because a row runs back" : ""),
                "sort the points into rows, and the rows by their position");
}

/// Returns the distance in plan between point `index` and point `index - back`.
double step_to(const GridDraft& grid, std::size_t index, std::size_t back) {
  return (grid.points[index] - grid.points[index - back]).head<2>().norm();
}

}  // namespace

double projected_area(const GridDraft& grid) {
  double twice = 0.0;
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      twice += cross_in_plan(grid.at(row + 1, column + 1) - grid.at(row, column),
                             grid.at(row + 1, column) - grid.at(row, column + 1));
    }
  }
  return 0.5 * twice;
}

void require_sound_grid(const GridDraft& grid) {
  if (grid.rows < 2 || grid.columns < 2) {
    refuse(grid.name,
           0,
           fmt::format("has {} rows of {} points", grid.rows, grid.columns),
           "a surface has at least two rows of two points; separate rows by blank lines");
  }
  refuse_equal_neighbours(grid);
  refuse_folds(grid);
}

FaultyPoints gaps_of(const GridDraft& grid) {
  std::vector<double> along;
  std::vector<double> across;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    if (i % grid.columns > 0) along.push_back(step_to(grid, i, 1));
    if (i >= grid.columns) across.push_back(step_to(grid, i, grid.columns));
  }
  const double longest_along = kGapFactor * median_of(along);
  const double longest_across = kGapFactor * median_of(across);
  FaultyPoints gaps;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    if ((i % grid.columns > 0 && step_to(grid, i, 1) > longest_along) ||
        (i >= grid.columns && step_to(grid, i, grid.columns) > longest_across)) {
      gaps.add(i);
    }
  }
  return gaps;
}

void require_near_points(const GridDraft& grid, double farthest_height_mm) {
  FaultyPoints far;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const Eigen::Vector3d& point = grid.points[i];
    const bool is_near = point.head<2>().cwiseAbs().maxCoeff() <= kFarthestMm;
    if (!is_near || std::abs(point.z()) > farthest_height_mm) far.add(i);
  }
  if (far.count() == 0) return;
  refuse_points(grid,
                far,
                fmt::format("{} points lie beyond {:g} m", far.count(), kFarthestMm / 1000.0),
                "check the unit, or move the origin to the part");
}

}  // namespace sim::surface

#include "host-sim/surface/patch/fit_report.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/surface/patch/grid_distance.hpp"
#include "host-sim/surface/patch/surface_distance.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

double share_of(Interval interval, double value) {
  return (value - interval.from) / (interval.to - interval.from);
}

/// The rows or columns in an interval, from `first` up to but not including `behind`. A row or
/// column at the end of the interval is excluded, unless it is the last of all `count` rows or
/// columns.
struct WholeNumbers {
  std::size_t first;
  std::size_t behind;

  WholeNumbers(Interval interval, std::size_t count)
      : first{static_cast<std::size_t>(std::ceil(interval.from))},
        behind{static_cast<std::size_t>(std::ceil(interval.to))} {
    if (behind + 1 == count) behind = count;
  }
};

/// Calls visit(row, column, point) once for each point of the grid. `point` is the point of the
/// surface with the same row and column as parameters.
template <typename Visit>
void for_each_point(const PatchSurface& surface, const PointGrid& grid, const Visit& visit) {
  for (std::uint32_t number = 0; number < surface.patches.size(); ++number) {
    const GridPatch& patch = surface.patches[number];
    const WholeNumbers rows{patch.u, grid.rows};
    const WholeNumbers columns{patch.v, grid.columns};
    for (std::size_t row = rows.first; row < rows.behind; ++row) {
      const double u = share_of(patch.u, static_cast<double>(row));
      const BezierCurve curve = patch.shape.curve_at_u(u);
      for (std::size_t column = columns.first; column < columns.behind; ++column) {
        const double v = share_of(patch.v, static_cast<double>(column));
        const double distance = (grid.at(row, column) - curve.at(v)).norm();
        visit(row, column, SurfacePoint{number, u, v, distance});
      }
    }
  }
}

void measure_points(const SurfaceDistance& distance,
                    const PatchSurface& surface,
                    const PointGrid& grid,
                    FitReport& report) {
  for_each_point(surface, grid, [&](std::size_t row, std::size_t column, const SurfacePoint& near) {
    ++report.points;
    if (near.distance_mm <= report.of_points.distance_mm) return;
    const double nearest = distance.nearest(grid.at(row, column), near).distance_mm;
    if (nearest <= report.of_points.distance_mm) return;
    report.of_points = {nearest, static_cast<double>(row), static_cast<double>(column)};
  });
}

/// Measures the distances of samples of one patch from the grid's triangles and adds them to
/// `report`.
void measure_patch(const GridDistance& distance,
                   const PointGrid& grid,
                   const GridPatch& patch,
                   FitReport& report) {
  const auto steps = [](Interval interval) {
    return std::max(1.0, std::ceil(kSamplesPerRow * (interval.to - interval.from)));
  };
  const auto quadrilateral = [](double value, std::size_t count) {
    return static_cast<std::uint32_t>(std::min(value, static_cast<double>(count) - 2.0));
  };
  PlacedError& worst = report.of_surface;
  for (double i = 0.0; i <= steps(patch.u); ++i) {
    const double u = i / steps(patch.u);
    const double row = patch.u.from + u * (patch.u.to - patch.u.from);
    const BezierCurve curve = patch.shape.curve_at_u(u);
    for (double j = 0.0; j <= steps(patch.v); ++j) {
      const double v = j / steps(patch.v);
      const double column = patch.v.from + v * (patch.v.to - patch.v.from);
      const Vector3d point = curve.at(v);
      ++report.samples;
      const double known = square_distance_from(
          grid, quadrilateral(row, grid.rows), quadrilateral(column, grid.columns), point);
      if (known <= worst.distance_mm * worst.distance_mm) continue;
      const double nearest = std::sqrt(distance.square_distance_from_all(point, known));
      if (nearest > worst.distance_mm) worst = {nearest, row, column};
    }
  }
}

}  // namespace

std::size_t points_beyond(const PatchSurface& surface, const PointGrid& grid, double tolerance_mm) {
  const SurfaceDistance distance{surface};
  std::size_t beyond = 0;
  for_each_point(surface, grid, [&](std::size_t row, std::size_t column, const SurfacePoint& near) {
    if (near.distance_mm <= tolerance_mm) return;
    if (!distance.is_within(grid.at(row, column), tolerance_mm, near)) ++beyond;
  });
  return beyond;
}

FitReport fit_report(const PatchSurface& surface, const PointGrid& grid, double tolerance_mm) {
  FitReport report;
  measure_points(SurfaceDistance{surface}, surface, grid, report);
  if (report.of_points.distance_mm > tolerance_mm) {
    report.points_beyond = points_beyond(surface, grid, tolerance_mm);
  }
  const GridDistance distance{grid};
  for (const GridPatch& patch : surface.patches) measure_patch(distance, grid, patch, report);
  return report;
}

}  // namespace sim::surface::patch

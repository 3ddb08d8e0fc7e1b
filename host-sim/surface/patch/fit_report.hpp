#pragma once

#include <cstddef>

#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// Number of samples of the surface that fit_report() takes along each step from row to row, and
/// from column to column. A quadrilateral thus has four samples.
inline constexpr double kSamplesPerRow = 2.0;

/// A distance, and the row and column at which it was measured.
struct PlacedError {
  double distance_mm = 0.0;
  double row = 0.0;
  double column = 0.0;
};

/// Errors of a fit: distances of the points from the surface, and of the surface from the points'
/// triangles.
struct FitReport {
  std::size_t points = 0;
  /// Number of points that are farther from the surface than the tolerance.
  std::size_t points_beyond = 0;
  PlacedError of_points;  ///< Greatest distance of a point from the surface.
  std::size_t samples = 0;
  /// Greatest distance of a sample of the surface from the triangles of the grid.
  PlacedError of_surface;
};

/// Returns the number of points that are farther from the surface than the tolerance.
///
/// Rows and columns of the grid are the parameters of the surface. For most points, the surface's
/// point with the same row and column is within tolerance. For the remaining points,
/// SurfaceDistance searches for a nearer point.
[[nodiscard]] std::size_t points_beyond(const PatchSurface& surface,
                                        const PointGrid& grid,
                                        double tolerance_mm);

/// Measures the greatest distances in both directions: of the points from the surface, and of
/// samples of the surface from the grid's triangles. There are kSamplesPerRow samples for each row
/// and column, and samples at both ends.
[[nodiscard]] FitReport fit_report(const PatchSurface& surface,
                                   const PointGrid& grid,
                                   double tolerance_mm);

}  // namespace sim::surface::patch

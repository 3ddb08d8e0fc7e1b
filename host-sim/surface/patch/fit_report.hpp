#pragma once

#include <cstddef>

#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// Samples of the surface for each row and each column of the grid that fit_report() takes, so that
/// there are four for a quadrilateral.
inline constexpr double kSamplesPerRow = 2.0;

/// A distance and the row and column at which it was measured.
struct PlacedError {
  double distance_mm = 0.0;
  double row = 0.0;
  double column = 0.0;
};

/// The errors of a fit in both directions.
struct FitReport {
  std::size_t points = 0;
  std::size_t points_beyond = 0;  ///< Points farther from the surface than the tolerance.
  PlacedError of_points;          ///< The greatest distance of a point from the surface.
  std::size_t samples = 0;
  PlacedError of_surface;  ///< The greatest distance of a sample from the triangles of the grid.
};

/// Returns the number of points that are farther from the surface than the tolerance.
///
/// Rows and columns of the grid are parameters of the surface. The distance at the same row and
/// column decides for most points; SurfaceDistance decides for the others.
[[nodiscard]] std::size_t points_beyond(const PatchSurface& surface,
                                        const PointGrid& grid,
                                        double tolerance_mm);

/// Returns the greatest distances in both directions: from the surface to the points, and from the
/// grid's triangles to samples of the surface, two for each row and column, both ends included.
[[nodiscard]] FitReport fit_report(const PatchSurface& surface,
                                   const PointGrid& grid,
                                   double tolerance_mm);

}  // namespace sim::surface::patch

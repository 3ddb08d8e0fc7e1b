#pragma once

#include <cstddef>

#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// Samples of the surface for each row and each column of the grid that fit_report() takes, so that
/// there are four for a quadrilateral.
inline constexpr double kSamplesPerRow = 2.0;

/// A distance and the row and column, or the parameters, that it belongs to.
struct PlacedError {
  double distance_mm = 0.0;
  double row = 0.0;
  double column = 0.0;
};

/// How well a surface and the points it was fitted to agree, in both directions.
struct FitReport {
  std::size_t points = 0;
  std::size_t points_beyond = 0;  ///< Points farther from the surface than the tolerance.
  PlacedError of_points;          ///< The greatest distance of a point from the surface.
  std::size_t samples = 0;
  PlacedError of_surface;  ///< The greatest distance of a sample from the triangles of the grid.
};

/// Returns the number of points that are farther from the surface than the tolerance.
///
/// The surface may be any that the grid's rows and columns are parameters of. The distance at the
/// same row and column settles most points; SurfaceDistance settles the others.
[[nodiscard]] std::size_t points_beyond(const PatchSurface& surface,
                                        const PointGrid& grid,
                                        double tolerance_mm);

/// Returns the distances in both directions: of all points from the surface, and from the grid's
/// triangles of samples of the surface, two for each row and column, those at both ends included.
[[nodiscard]] FitReport fit_report(const PatchSurface& surface,
                                   const PointGrid& grid,
                                   double tolerance_mm);

}  // namespace sim::surface::patch

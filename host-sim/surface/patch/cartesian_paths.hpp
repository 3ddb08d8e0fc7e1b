#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "host-sim/surface/patch/fit_report.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/patch/plane_slices.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// Numbers of flat pieces into which a surface is divided, by flatness test and kind of split. The
/// tests and splits are those of paper 4 and those of this program.
struct PieceCounts {
  /// Number of pieces by splits in four until the control points are flat.
  std::size_t control_hull = 0;
  std::size_t fat_plane = 0;  ///< Number of pieces by splits in four with the fat plane of paper 4.
  /// Number of pieces by splits in four with the fat planes in both orders.
  std::size_t both_orders = 0;
  /// Number of pieces by splits in two with the fat planes in both orders.
  std::size_t fewest_halvings = 0;
};

[[nodiscard]] PieceCounts piece_counts(const PatchSurface& surface, double flatness_mm);

/// Tolerances and layout of paths in parallel vertical planes. The fit tolerance limits the
/// distance between the given points and the fitted surface. The chord tolerance limits the
/// distance between the fitted surface and the chords of the paths.
struct PathOptions {
  double fit_tolerance_mm = 0.005;  ///< Largest distance of a point from the surface.
  /// Largest distance of a chord from the surface, in the chord's plane.
  double chord_tolerance_mm = 0.005;
  double spacing_mm = 0.5;  ///< Distance between planes.
  double angle = 0.0;       ///< Angle in radians from +X to the paths, counter-clockwise.
};

/// A fitted surface and the paths over it.
struct CartesianPaths {
  PatchSurface surface;
  FitReport report;
  std::size_t pieces = 0;
  Eigen::Vector3d plane_normal = Eigen::Vector3d::UnitY();
  /// Distances of the planes from the origin along `plane_normal`, ascending.
  std::vector<double> plane_distances_mm;
  std::vector<std::vector<SlicePath>> paths;  ///< Paths in each plane, in the order of the planes.
};

/// Fits a surface to points, for example tool positions, and cuts the surface with parallel
/// vertical planes (paper 4). The planes are centred over the surface's width. The outer planes are
/// thus at most half a spacing from the surface's ends.
/// @pre the grid has at least two rows and columns, and its coordinates are finite; tolerances and
/// spacing are above 0
[[nodiscard]] CartesianPaths cartesian_paths(const PointGrid& grid, const PathOptions& options);

}  // namespace sim::surface::patch

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "host-sim/surface/patch/fit_report.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/patch/plane_slices.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// Numbers of flat pieces by the tests and splits that paper 4 compares, and by ours.
struct PieceCounts {
  std::size_t control_hull = 0;     ///< Splits in four until the control points are flat.
  std::size_t fat_plane = 0;        ///< Splits in four by the paper's fat plane.
  std::size_t both_orders = 0;      ///< Splits in four by the fat plane in both orders.
  std::size_t fewest_halvings = 0;  ///< Splits in two by the fat plane in both orders.
};

[[nodiscard]] PieceCounts piece_counts(const PatchSurface& surface, double flatness_mm);

/// Tolerances and layout of paths in parallel upright planes. The first tolerance holds between the
/// points and the surface, the second between the surface and the chords.
struct PathOptions {
  double fit_tolerance_mm = 0.005;    ///< Largest distance of a point from the surface.
  double chord_tolerance_mm = 0.005;  ///< Largest distance of a chord in its plane.
  double spacing_mm = 0.5;            ///< Between planes.
  double angle = 0.0;                 ///< Radians from +X to the paths, counter-clockwise.
};

/// A fitted surface and the paths over it.
struct CartesianPaths {
  PatchSurface surface;
  FitReport report;
  std::size_t pieces = 0;
  Eigen::Vector3d plane_normal = Eigen::Vector3d::UnitY();
  std::vector<double> plane_distances_mm;     ///< From the origin, ascending.
  std::vector<std::vector<SlicePath>> paths;  ///< For each plane, its paths.
};

/// Fits a surface to points, such as positions of a tool, and slices it (paper 4). The planes lie
/// in the middle of the surface's width, so that the outer ones are at most half a spacing from it.
/// @pre the grid has two rows and columns at least, its coordinates are finite; tolerances and
/// spacing are above 0
[[nodiscard]] CartesianPaths cartesian_paths(const PointGrid& grid, const PathOptions& options);

}  // namespace sim::surface::patch

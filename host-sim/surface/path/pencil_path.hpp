#pragma once

#include <cstddef>

#include "host-sim/surface/path/row_path.hpp"

namespace sim::surface {

/// Which valleys a pencil path follows.
struct PencilOptions {
  double angle_rad = 0.35;  ///< Least angle between the normals of both sides; above 0.
  double least_mm = 1.0;    ///< Shorter lines are left out.
};

/// A path along valleys, and the lines that were too short.
struct PencilPath {
  SurfacePath path;
  std::size_t left_out = 0;
};

/// Returns the path of a tool along the valleys in which it touches the surface on both sides, and
/// along the feet of upright walls. It is traced as rows are, so that it never cuts in, and within
/// the tolerance of the valley in the plan, at a wall up to twice that beside it. Valleys are found
/// on a grid whose pitch is an eighth of the tool's radius.
/// @param options tool, allowance, tolerance, floor, regions and lines of rows; no steps
/// Throws std::invalid_argument where there is no valley.
/// @pre the mesh has facets
[[nodiscard]] PencilPath pencil_path(const Mesh& mesh,
                                     const RowOptions& options,
                                     const PencilOptions& pencil);

}  // namespace sim::surface

#pragma once

#include <cstddef>

#include "host-sim/surface/path/row_path.hpp"

namespace sim::surface {

/// Options that select the valleys for a pencil path.
struct PencilOptions {
  double angle_rad = 0.35;  ///< Minimum angle between the normals of a valley's sides, > 0.
  double min_mm = 1.0;      ///< Minimum length of a line. Shorter lines are left out.
};

/// A path along valleys, and the number of lines that were left out because they were too short.
struct PencilPath {
  SurfacePath path;
  std::size_t left_out = 0;
};

/// Returns the path of a tool along the valleys in which it touches the surface on both sides, and
/// along the feet of vertical walls. The path is traced in the same way as rows, so that it never
/// cuts into the surface. In plan, it is within the tolerance of the valley. At a wall, it may be
/// offset by up to twice the tolerance. Valleys are found on a grid whose pitch is an eighth of the
/// tool's radius.
/// @param options tool, allowance, tolerance, floor, regions and lines as for rows. Steps are
/// ignored
/// Throws std::invalid_argument if there is no valley.
/// @pre the mesh has facets
[[nodiscard]] PencilPath pencil_path(const Mesh& mesh,
                                     const RowOptions& options,
                                     const PencilOptions& pencil);

}  // namespace sim::surface

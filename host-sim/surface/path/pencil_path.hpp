#pragma once

#include <cstddef>

#include "host-sim/surface/path/row_path.hpp"

namespace sim::surface {

/// Selects the valleys that a pencil path follows.
struct PencilOptions {
  double angle_rad = 0.35;  ///< Minimum angle between the normals of both sides; above 0.
  double min_mm = 1.0;      ///< Minimum length of a line; shorter lines are left out.
};

/// A path along valleys, and the number of lines that were too short.
struct PencilPath {
  SurfacePath path;
  std::size_t left_out = 0;
};

/// Returns the path of a tool along the valleys in which it touches the surface on both sides, and
/// along the feet of vertical walls. The path is traced like rows are, so that it never cuts into
/// the surface. In plan it is within the tolerance of the valley; at a wall it may be offset by up
/// to twice the tolerance. Valleys are found on a grid whose pitch is an eighth of the tool's
/// radius.
/// @param options tool, allowance, tolerance, floor, regions and lines as for rows; steps are
/// ignored
/// Throws std::invalid_argument if there is no valley.
/// @pre the mesh has facets
[[nodiscard]] PencilPath pencil_path(const Mesh& mesh,
                                     const RowOptions& options,
                                     const PencilOptions& pencil);

}  // namespace sim::surface

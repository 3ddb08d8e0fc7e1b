#pragma once

#include <cstdint>

#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// Returns a composite bicubic Bézier surface that is within tolerance of all points of the grid.
/// The method is adaptive subdivision in the manner of Schmitt, Barsky and Du (1986). At first, one
/// patch covers the grid. A patch is split in four if a point is too far from the surface. It is
/// also split if the surface at a point's row and column is too far from the grid's triangles
/// around the point.
///
/// All patches at a corner use the same position, tangents and twist. These values are estimated
/// from the points around the corner or, for a hanging corner, taken from the coarser patch. A
/// border and the derivatives across it are cubics with the same ends on both sides, so they are
/// equal. The surface is therefore once continuously differentiable by row and column. Where these
/// derivatives are linearly independent, the tangent plane is continuous, also between patches of
/// different size.
///
/// The subdivision ends at the latest with one patch for each quadrilateral, because such a patch
/// passes through its corners.
/// @pre the grid has at least two rows and columns, and its coordinates are finite; tolerance > 0
[[nodiscard]] PatchSurface fitted_surface(const PointGrid& grid, double tolerance_mm);

}  // namespace sim::surface::patch

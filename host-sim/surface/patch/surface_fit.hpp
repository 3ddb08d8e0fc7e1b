#pragma once

#include <cstdint>

#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// Returns a composite bicubic Bézier surface that all points of the grid are within tolerance of,
/// by adaptive subdivision in the manner of Schmitt, Barsky and Du (1986). One patch covers the
/// grid; where a point is too far from the surface, or the surface at the point's row and column is
/// too far from the grid's triangles around, its patches are split in four.
///
/// All patches at a corner take its position, two tangents and twist from one source: an estimate
/// from the points around, or the coarser patch where the corner hangs in its border. A border and
/// the derivatives across it are cubic on both sides and thus the same: the surface is once
/// continuously differentiable by row and column, and has one tangent plane at every joint, those
/// of patches of different size included, wherever its derivatives are independent.
///
/// It ends because a patch of one quadrilateral passes through its corners, so that there is at
/// most one patch for each quadrilateral.
/// @pre the grid has two rows and columns at least, and its coordinates are finite; tolerance > 0
[[nodiscard]] PatchSurface fitted_surface(const PointGrid& grid, double tolerance_mm);

}  // namespace sim::surface::patch

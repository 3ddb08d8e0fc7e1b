#pragma once

#include <cstdint>

#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/point_grid.hpp"

namespace sim::surface::patch {

/// Returns a composite bicubic Bézier surface that is within tolerance of all points of the grid.
/// It is found by adaptive subdivision in the manner of Schmitt, Barsky and Du (1986). At first one
/// patch covers the grid. Patches are split in four where a point is too far from the surface, or
/// where the surface at a point's row and column is too far from the grid's triangles around that
/// point.
///
/// All patches at a corner take its position, two tangents and twist from one source: an estimate
/// from the points around it, or the coarser patch if the corner hangs in that patch's border. A
/// border and the derivatives across it are cubic on both sides and thus the same. The surface is
/// therefore once continuously differentiable by row and column. Wherever these derivatives are
/// linearly independent it has one tangent plane at every joint, also between patches of different
/// size.
///
/// The subdivision ends because a patch of one quadrilateral passes through its corners, so that
/// there is at most one patch for each quadrilateral.
/// @pre the grid has at least two rows and columns, and its coordinates are finite; tolerance > 0
[[nodiscard]] PatchSurface fitted_surface(const PointGrid& grid, double tolerance_mm);

}  // namespace sim::surface::patch

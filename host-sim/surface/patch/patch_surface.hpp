#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/patch/bezier_patch.hpp"

namespace sim::surface::patch {

/// A patch over a rectangle of a grid's rows (u) and columns (v). The ends of the intervals are
/// multiples of a power of 1/2, so that the ends of adjacent patches are exactly equal.
struct GridPatch {
  Interval u;
  Interval v;
  BezierPatch shape;
};

/// A surface of patches over a grid of points; lengths are mm.
struct PatchSurface {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<GridPatch> patches;
};

}  // namespace sim::surface::patch

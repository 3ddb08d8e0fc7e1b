#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/patch/bezier_patch.hpp"

namespace sim::surface::patch {

/// A patch over a rectangle of a grid's rows (u) and columns (v). The ends are whole numbers,
/// halves, quarters and so on, so that patches that meet have equal ends.
struct GridPatch {
  Interval u;
  Interval v;
  BezierPatch shape;
};

/// A composite surface over a grid of points; mm.
struct PatchSurface {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<GridPatch> patches;
};

}  // namespace sim::surface::patch

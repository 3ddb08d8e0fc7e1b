#pragma once

#include <algorithm>

#include "host-sim/surface/patch/flatness.hpp"

namespace sim::surface::patch {

/// Returns the extremes of a patch along a normal: exactly along v, and at 33 values of u. The
/// range is too narrow by a hundredth at most.
inline Range exact_range(const BezierPatch& patch, const Eigen::Vector3d& normal) {
  Range range{.lowest = normal.dot(patch.control(0, 0)), .highest = range.lowest};
  for (int i = 0; i <= 32; ++i) {
    const BezierCurve curve = patch.curve_at_u(i / 32.0);
    Cubic distances{};
    for (std::size_t j = 0; j < 4; ++j) distances[j] = normal.dot(curve.controls[j]);
    const Range along_v = range_of(distances);
    range.lowest = std::min(range.lowest, along_v.lowest);
    range.highest = std::max(range.highest, along_v.highest);
  }
  return range;
}

}  // namespace sim::surface::patch

#pragma once

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Returns the least distance between two strokes, mm; 0 if they cross.
///
/// The nearest points are two ends, an end and its foot on the other stroke, a crossing, or two
/// feet on a common normal. All of these are tried, so the result is exact except for the rounding
/// of the arcs' centres. The error is at most 1e-6 mm for strokes within 1 m of each other.
[[nodiscard]] double distance_between(const Stroke& a, const Stroke& b);

}  // namespace sim::cut

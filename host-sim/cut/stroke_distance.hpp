#pragma once

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Returns the distance between the nearest points of two strokes, mm; 0 where they cross.
///
/// The nearest points are both ends, an end and a foot, a crossing, or two feet on a common normal,
/// which are all tried: exact but for the rounding of the arcs' centres. Error at most 1e-6 mm for
/// strokes within 1 m of each other.
[[nodiscard]] double distance_between(const Stroke& a, const Stroke& b);

}  // namespace sim::cut

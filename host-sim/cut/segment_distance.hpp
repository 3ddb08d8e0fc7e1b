#pragma once

#include <vector>

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Returns the centre of an arc.
/// @pre the bulge is not 0
[[nodiscard]] Place arc_centre(const Stroke& arc);

/// Returns the point of a stroke that is nearest to another point.
[[nodiscard]] Place nearest_on(const Stroke& stroke, const Place& place);

/// Returns the share of a stroke's length, 0 to 1, at the point of the stroke that is nearest to
/// `place`.
[[nodiscard]] double nearest_share(const Stroke& stroke, const Place& place);

/// Returns the least distance between a straight segment and a stroke, mm; 0 if they cross. The
/// result is exact except for rounding, which is below 1e-9 mm for points within 10 m of each
/// other.
[[nodiscard]] double segment_distance(const Place& from, const Place& to, const Stroke& stroke);

/// Appends the shares of a segment's length, 0 to 1, at which the segment crosses a stroke.
void add_meetings(const Place& from,
                  const Place& to,
                  const Stroke& stroke,
                  std::vector<double>& shares);

}  // namespace sim::cut

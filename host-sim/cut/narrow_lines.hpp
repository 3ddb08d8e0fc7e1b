#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Lines along the middle of waste that is narrower than the kerf.
struct NarrowLines {
  std::vector<std::vector<Stroke>> rows{};
  double length_mm = 0.0;    ///< Length of all.
  double most_off_mm = 0.0;  ///< Greatest width that a cut along them takes off an edge…
  Place place{0.0, 0.0};     ///< …and where that is.
};

/// Finds lines along the medial axis of waste wherever it is narrower than the kerf: from path to
/// path in a neck or a gap, from a path into a slot or a sharp tip, and along a hole which no path
/// is in. Corners wider than 60 degrees have none. A hole that is about as long as wide has a line
/// of a quarter of the kerf in its middle.
///
/// Guarantee: a cut along them takes no more than `most_off_mm` off an edge (within 0.5 % of the
/// kerf); one in the middle of such a hole an eighth of the kerf more.
/// Throws std::runtime_error with the place where contours cross.
/// @param waste closed contours with the waste on their left, which may touch
/// @param half_kerf_mm above 0
/// @param most_off_mm above 0; half the kerf or more is no limit
[[nodiscard]] NarrowLines narrow_lines(const cnc::contour::ContourView<double>& waste,
                                       double half_kerf_mm,
                                       double most_off_mm);

}  // namespace sim::cut

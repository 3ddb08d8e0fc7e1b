#pragma once

#include <functional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Lines along the middle of waste that is narrower than the kerf.
struct NarrowLines {
  std::vector<std::vector<Stroke>> rows{};
  double length_mm = 0.0;   ///< Total length of the lines.
  double max_off_mm = 0.0;  ///< Greatest width that a cut along these lines takes off an edge.
  Place place{0.0, 0.0};    ///< The point where this width occurs.
};

/// Finds lines along the medial axis of waste, wherever the waste is narrower than the kerf. In a
/// neck or a gap, a line leads from path to path. In a slot or a sharp tip, it leads inwards from a
/// path. In a hole that contains no path, it leads along the hole. Corners wider than 60 degrees
/// have no line. A hole that is about as long as wide has a line of a quarter of the kerf in its
/// middle.
///
/// Guarantee: a cut along these lines takes no more than `max_off_mm` off an edge, within 0.5 % of
/// the kerf. A line in the middle of a hole that is about as long as wide may take an eighth of the
/// kerf more. A line ends half a kerf before the end of a slot. Where the slot ends at other waste,
/// the line leads to its end, because parts at both sides would hold together by the corners that
/// the beam does not reach. Throws std::runtime_error with the point if contours cross.
/// @param waste closed contours with the waste on their left, which may touch
/// @param half_kerf_mm above 0
/// @param max_off_mm above 0; a value of half the kerf or more is no limit
/// @param is_other_near returns whether the outline of other waste is within a distance, mm, of a
///     point; empty if there is no other waste
[[nodiscard]] NarrowLines narrow_lines(
    const cnc::contour::ContourView<double>& waste,
    double half_kerf_mm,
    double max_off_mm,
    const std::function<bool(const Place&, double)>& is_other_near = {});

}  // namespace sim::cut

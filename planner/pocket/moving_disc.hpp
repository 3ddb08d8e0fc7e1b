#pragma once

#include "planner/pocket/area_distance.hpp"

namespace cnc::pocket {

/// A disc that moves along a straight line while its radius changes in proportion to the way: at
/// any height, the cut of a V-shaped tool whose tip moves straight.
struct MovingDisc {
  WideVec2 from{0.0, 0.0};
  WideVec2 to{0.0, 0.0};
  double from_radius = 0.0;  ///< mm.
  double to_radius = 0.0;    ///< mm; differs from the other by less than the length of the way.
};

/// Returns the greatest length by which the disc reaches across the boundary on its way, mm; 0 if
/// it stays in the area. Exact but for rounding: the least of "distance from an element less
/// radius" is at an end of the way, or where the way passes the end of an element, or is a minimum
/// of the distance from a point, which has a closed form.
///
/// @pre the way does not leave the area
[[nodiscard]] double excess_of(const MovingDisc& disc, const AreaDistance& area);

}  // namespace cnc::pocket

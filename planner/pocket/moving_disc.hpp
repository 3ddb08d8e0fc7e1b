#pragma once

#include "planner/pocket/area_distance.hpp"

namespace cnc::pocket {

/// A disc that moves along a straight line while its radius changes in proportion to the distance.
/// If the tip of a V-shaped tool moves straight, the disc is the section of the tool at any height.
struct MovingDisc {
  WideVec2 from{0.0, 0.0};
  WideVec2 to{0.0, 0.0};
  double from_radius = 0.0;  ///< Radius at the start, mm.
  /// Radius at the end, mm. It differs from `from_radius` by less than the length of the line.
  double to_radius = 0.0;
};

/// Returns the greatest length by which the moving disc extends across the boundary, mm; 0 if it
/// stays in the area. The result is exact except for rounding. The distance from an element minus
/// the radius is least at an end of the line or at a minimum between the ends. Only the distance
/// from an element's end or from an arc's centre has such a minimum, and a closed form gives it.
///
/// @pre the line does not leave the area
[[nodiscard]] double excess_of(const MovingDisc& disc, const AreaDistance& area);

}  // namespace cnc::pocket

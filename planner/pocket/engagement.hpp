#pragma once

#include "planner/geometry/vector.hpp"

namespace cnc::pocket {

/// A disc from which all stock has been removed.
struct ClearedDisc {
  WideVec2 centre{0.0, 0.0};
  double radius = 0.0;  ///< mm.
};

/// Returns the engagement of a tool, in radians, 0 to π: the angle of the part of the leading half
/// of the tool's circumference that is outside a cleared disc. This part cuts if there is stock
/// everywhere outside the disc.
/// @param direction  unit vector of the tool's motion
/// @pre tool_radius_mm > 0
[[nodiscard]] double engagement(const ClearedDisc& cleared,
                                double tool_radius_mm,
                                const WideVec2& place,
                                const WideVec2& direction);

/// A circle along which the centre of a tool moves.
struct ToolCircle {
  WideVec2 centre{0.0, 0.0};
  /// Radius of this circle, mm. The disc that the tool clears is larger by the tool's radius.
  double radius = 0.0;
};

/// The arc of the next circle along which the tool cuts. On the circle before, the tool has cleared
/// a disc. The disc of the next circle extends beyond the cleared disc by a crescent. The arc turns
/// left.
struct Crescent {
  WideVec2 begin{0.0, 0.0};   ///< First intersection of the two circles.
  WideVec2 middle{0.0, 0.0};  ///< Point farthest from the cleared circle.
  WideVec2 end{0.0, 0.0};     ///< Second intersection of the two circles.
  /// Bulge of the arc from `begin` to `middle`, and of the arc from `middle` to `end`.
  double bulge = 0.0;
  bool exists = false;  ///< Whether the circles intersect.
};
[[nodiscard]] Crescent crescent_between(const ToolCircle& cleared, const ToolCircle& next);

/// Returns the greatest engagement along a crescent, in radians. The error is below 0.001 rad.
/// @pre the crescent exists
[[nodiscard]] double crescent_engagement(const ToolCircle& cleared,
                                         const ToolCircle& next,
                                         double tool_radius_mm);

}  // namespace cnc::pocket

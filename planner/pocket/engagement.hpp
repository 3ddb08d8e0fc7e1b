#pragma once

#include "planner/geometry/vector.hpp"

namespace cnc::pocket {

/// A disc of which the stock is gone.
struct ClearedDisc {
  WideVec2 centre{0.0, 0.0};
  double radius = 0.0;  ///< mm.
};

/// Returns the angle of a tool's leading half that is outside of a cleared disc, in radians: how
/// much of its circumference cuts where stock is left everywhere else. 0 to π.
/// @param direction  in which the tool moves, of length 1
/// @pre tool_radius_mm > 0
[[nodiscard]] double engagement(const ClearedDisc& cleared,
                                double tool_radius_mm,
                                const WideVec2& place,
                                const WideVec2& direction);

/// A circle on which the centre of a tool goes.
struct ToolCircle {
  WideVec2 centre{0.0, 0.0};
  double radius = 0.0;  ///< mm; the tool clears a disc that is wider by its own radius.
};

/// The crescent by which the disc that a tool clears around one circle reaches beyond that around
/// another: the arc of the circle, to the left, on which the tool cuts.
struct Crescent {
  WideVec2 begin{0.0, 0.0};   ///< Where both circles meet.
  WideVec2 middle{0.0, 0.0};  ///< Farthest from the other circle.
  WideVec2 end{0.0, 0.0};     ///< Where both circles meet again.
  double bulge = 0.0;         ///< Of the arc from `begin` to `middle`, and of that to `end`.
  bool exists = false;        ///< False if the circles do not meet.
};
[[nodiscard]] Crescent crescent_between(const ToolCircle& cleared, const ToolCircle& next);

/// Returns the greatest engagement along a crescent, in radians. Error below 0.001 rad.
/// @pre the crescent exists
[[nodiscard]] double crescent_engagement(const ToolCircle& cleared,
                                         const ToolCircle& next,
                                         double tool_radius_mm);

}  // namespace cnc::pocket

#pragma once

#include "planner/motion/lookahead/arc_axes.hpp"

namespace cnc::motion {

/// The vectors, given by their parts along the tangent and along its normal, that are within the
/// accelerations of all axes wherever the tangent is within an angle. Lives only as long as `axes`.
class DirectionBox {
 public:
  /// @param first, last radians, of the tangent
  DirectionBox(float first, float last, const ArcAxes& axes);

  [[nodiscard]] bool holds(float tangent, float normal) const;
  /// Returns the length of the longest vector along the tangent that it holds.
  [[nodiscard]] float most_along() const;

 private:
  [[nodiscard]] float turned(float own, float other) const;

  SinCos middle_;
  SinCos half_;
  const ArcAxes& axes_;
};

}  // namespace cnc::motion

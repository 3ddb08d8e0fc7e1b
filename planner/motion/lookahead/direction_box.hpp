#pragma once

#include "planner/motion/lookahead/arc_axes.hpp"

namespace cnc::motion {

/// The set of acceleration vectors that exceed no axis's limit, for every tangent in a range of
/// angles. A vector is given by its components along the tangent and along the normal. The object
/// refers to `axes`, which must outlive it.
class DirectionBox {
 public:
  /// @param first, last angles of the tangent, in radians
  DirectionBox(float first, float last, const ArcAxes& axes);

  [[nodiscard]] bool holds(float tangent, float normal) const;
  /// Returns the length of the longest vector along the tangent that is in the box.
  [[nodiscard]] float max_along() const;

 private:
  [[nodiscard]] float turned(float own, float other) const;

  SinCos middle_;
  SinCos half_;
  const ArcAxes& axes_;
};

}  // namespace cnc::motion

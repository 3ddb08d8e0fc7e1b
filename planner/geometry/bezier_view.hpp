#pragma once

#include <array>
#include <cstddef>

#include "planner/geometry/bezier.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

/// A point of a curve, and the direction of the curve at that point.
struct CurvePoint {
  Vec2 place;
  Vec2 direction;  ///< Vector of any length; null at a cusp.
};

/// A Bézier curve in single precision, in mm, in a frame near the curve. `origin` is the frame's
/// origin, and the frame's x axis is along the unit vector `along`.
class BezierView {
 public:
  BezierView() = default;
  BezierView(const Bezier& bezier, const PlanePlace& origin, const Vec2& along);

  /// Returns a point of the curve. @param parameter 0…1.
  [[nodiscard]] CurvePoint at(float parameter) const;

 private:
  using Row = std::array<float, Bezier::kHighestDegree + 1>;

  // Coordinates of the control points multiplied by their weights, and the weights.
  Row x_{};
  Row y_{};
  Row weight_{};
  std::size_t degree_ = 1;
};

}  // namespace cnc

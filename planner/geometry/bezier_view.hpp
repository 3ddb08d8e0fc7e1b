#pragma once

#include <array>
#include <cstddef>

#include "planner/geometry/bezier.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

/// A point of a curve, and which way it goes there.
struct CurvePoint {
  Vec2 place;
  Vec2 direction;  ///< Of any length; null at a cusp.
};

/// A Bézier curve in single precision but seen from a place near it: origin there, x along
/// a unit vector, mm.
class BezierView {
 public:
  BezierView() = default;
  BezierView(const Bezier& bezier, const PlanePlace& origin, const Vec2& along);

  /// @param parameter 0…1.
  [[nodiscard]] CurvePoint at(float parameter) const;

 private:
  using Row = std::array<float, Bezier::kHighestDegree + 1>;

  // Control points times their weights.
  Row x_{};
  Row y_{};
  Row weight_{};
  std::size_t degree_ = 1;
};

}  // namespace cnc

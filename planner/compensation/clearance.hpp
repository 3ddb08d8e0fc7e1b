#pragma once

#include "planner/contour/curve.hpp"

namespace cnc::compensation {

using Curve = contour::Curve<float>;

/// Greatest distance, mm, of points that count as one point, for coordinates in single precision
/// relative to a near origin.
inline constexpr float kTouch = 2.0e-5F;

/// Greatest amount, mm, by which a path may be nearer to an edge than the offset.
inline constexpr float kTolerance = 5.0e-5F;

/// Returns a straight curve. @pre `start` and `end` differ, or the tangent of the result has no
/// meaning
[[nodiscard]] Curve straight(const Vec2& start, const Vec2& end);

/// Returns the distance from a point to the nearest point of a curve, mm. The path at an offset
/// from a narrow arc runs near the centre of that arc. There this result keeps all digits, while
/// Curve::distance loses half of them.
[[nodiscard]] float distance(const Curve& curve, const Vec2& place);

/// Returns whether any point of one curve is nearer than `limit` mm to a point of the other curve.
/// Only the points that can be nearest are compared: ends, meetings and points with parallel
/// tangents. The result is exact except for the rounding of the distances there.
[[nodiscard]] bool come_nearer(const Curve& a, const Curve& b, float limit);

}  // namespace cnc::compensation

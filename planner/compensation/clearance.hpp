#pragma once

#include "planner/contour/curve.hpp"

namespace cnc::compensation {

using Curve = contour::Curve<float>;

/// Points in single precision, relative to a near origin, that are at most this far apart count as
/// one point. mm.
inline constexpr float kTouch = 2.0e-5F;

/// A path that is nearer to an edge than the offset by more than this is too near. mm.
inline constexpr float kTolerance = 5.0e-5F;

/// Returns a straight curve. @pre its ends are apart, or its tangent means nothing
[[nodiscard]] Curve straight(const Vec2& start, const Vec2& end);

/// Returns the distance from a point to the nearest point of a curve, mm. Curve::distance loses
/// half of the digits near the centre of an arc, and the path at an offset from a narrow arc runs
/// there.
[[nodiscard]] float distance(const Curve& curve, const Vec2& place);

/// Returns whether any point of one curve is nearer than `limit` mm to a point of the other. The
/// result is exact to the last bit of the distances at the points that can be nearest: ends,
/// meetings and points with parallel tangents.
[[nodiscard]] bool come_nearer(const Curve& a, const Curve& b, float limit);

}  // namespace cnc::compensation

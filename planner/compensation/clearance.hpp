#pragma once

#include "planner/contour/curve.hpp"

namespace cnc::compensation {

using Curve = contour::Curve<float>;

/// Places of single precision, seen from a place near by, that are one. mm.
inline constexpr float kTouch = 2.0e-5F;

/// Nearer than the offset by more than this is too near. mm.
inline constexpr float kTolerance = 5.0e-5F;

/// A straight way. @pre its ends are apart, or the tangent means nothing
[[nodiscard]] Curve straight(const Vec2& start, const Vec2& end);

/// From a place to the nearest one of a curve, mm. Curve::distance loses half of the digits near
/// the centre of an arc, which is where the path beside a narrow one runs.
[[nodiscard]] float distance(const Curve& curve, const Vec2& place);

/// Whether any place of one curve is nearer than `limit` mm to one of the other. To the bit of
/// the distances at the places that can be nearest: ends, meetings, parallel tangents.
[[nodiscard]] bool come_nearer(const Curve& a, const Curve& b, float limit);

}  // namespace cnc::compensation

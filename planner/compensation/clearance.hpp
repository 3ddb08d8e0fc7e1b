#pragma once

#include "planner/contour/curve.hpp"

namespace cnc::compensation {

using Curve = contour::Curve<float>;

/// Places of single precision, seen from a place near by, that are one. mm.
inline constexpr float kTouch = 2.0e-5F;

/// Whether any place of one curve is nearer than `limit` mm to one of the other. To the bit of
/// the distances at the places that can be nearest: ends, meetings, parallel tangents.
[[nodiscard]] bool come_nearer(const Curve& a, const Curve& b, float limit);

}  // namespace cnc::compensation

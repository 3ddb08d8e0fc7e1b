#pragma once

#include "planner/geometry/spline.hpp"

namespace cnc {

/// A rectangle, relative to the first control point of a spline.
struct PlaneBox {
  PlanePlace least{};
  PlanePlace most{};
};

/// Returns whether the complete curve, and not only its ends, is in the box. Where the curve comes
/// near a side, the hulls of smaller and smaller parts of it decide. The result is exact, except
/// that a curve that comes within kReachDoubtNm of a side may count as outside.
inline constexpr std::int64_t kReachDoubtNm = 200;
[[nodiscard]] bool stays_within(const Spline& spline, const PlaneBox& box);

}  // namespace cnc

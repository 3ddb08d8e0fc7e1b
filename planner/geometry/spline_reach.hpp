#pragma once

#include "planner/geometry/spline.hpp"

namespace cnc {

/// A rectangle, from the first control point of a spline.
struct PlaneBox {
  PlanePlace least{};
  PlanePlace most{};
};

/// Whether all of the curve, and not only its ends, lies in the box. Decided by
/// the hulls of ever smaller parts of it where it comes near a side: exact, but
/// that a curve which touches one within kReachDoubtNm counts as outside.
inline constexpr std::int64_t kReachDoubtNm = 200;
[[nodiscard]] bool stays_within(const Spline& spline, const PlaneBox& box);

}  // namespace cnc

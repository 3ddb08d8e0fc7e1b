#pragma once

#include <cstdint>

#include "planner/base/result.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

enum class BiarcError : std::uint8_t {
  kChordTooShort,  ///< The ends are closer than BasicArc::kShortestChord.
  kSweepTooLarge,  ///< One of the arcs would have a sweep of more than half a turn.
};

/// Start and end of a curve, with the direction of the curve at each of them.
template <typename Scalar>
struct BasicBiarcEnds {
  BasicVec2<Scalar> start;
  BasicVec2<Scalar> start_tangent;  ///< Unit vector.
  BasicVec2<Scalar> end;
  BasicVec2<Scalar> end_tangent;  ///< Unit vector.
};
using BiarcEnds = BasicBiarcEnds<float>;
using WideBiarcEnds = BasicBiarcEnds<double>;

/// Two arcs that meet at `joint` with one tangent. The arcs are given by their bulges (see Arc).
template <typename Scalar>
struct BasicBiarc {
  BasicVec2<Scalar> joint;
  BasicVec2<Scalar> joint_tangent;  ///< Unit vector.
  Scalar first_bulge;
  Scalar second_bulge;
};
using Biarc = BasicBiarc<float>;
using WideBiarc = BasicBiarc<double>;

/// Returns the two arcs through both ends with both tangents. Of all such pairs of arcs it is the
/// pair whose joint is at `joint_share` on the circle of all joints.
///
/// Let a and b be the angles from the chord to the start and end tangent, in (−π, π], and let w be
/// half of b − a. All joints are on the arc from start to end with half sweep w (Bolton, CAD 7
/// (1975) 29). At the share s of that arc the half sweeps of the two arcs are −a − (1 − s) w and b
/// − s w, and their chords are L sin(s w) / sin w and L sin((1 − s) w) / sin w. The formulas do not
/// divide by a difference of tangents. So C shapes, S shapes, parallel tangents (w = 0), a single
/// arc (a = −b) and a line need no separate cases.
///
/// There are two ways to turn from one end tangent to the other. The result turns in the way that
/// turns less relative to the chord, and has no loops.
///
/// Guarantee: the tangents at both ends and at the joint are exact within kBiarcTangentError
/// radians, and the joint is exact within kBiarcJointError · L. In double precision both errors are
/// at most kWideBiarcError.
/// @param joint_share 0…1, both ends excluded.
inline constexpr double kBiarcTangentError = 2.0e-6;
inline constexpr double kBiarcJointError = 2.0e-6;
inline constexpr double kWideBiarcError = 2.0e-14;
[[nodiscard]] Result<Biarc, BiarcError> make_biarc(const BiarcEnds& ends, float joint_share);
[[nodiscard]] Result<WideBiarc, BiarcError> make_biarc(const WideBiarcEnds& ends,
                                                       double joint_share);

/// Returns the bulge of the arc over `chord` that begins in the direction `tangent`. With the two
/// arguments exchanged, it is the bulge of the arc that ends in that direction. For arcs of at most
/// half a turn the result is in −1…1. For longer arcs the result is meaningless but bounded. The
/// result is 0 if one of the two vectors is null.
[[nodiscard]] float bulge_between(const Vec2& tangent, const Vec2& chord);
[[nodiscard]] double wide_bulge_between(const WideVec2& tangent, const WideVec2& chord);

}  // namespace cnc

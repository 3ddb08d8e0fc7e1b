#pragma once

#include <cstdint>

#include "planner/base/result.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

enum class BiarcError : std::uint8_t {
  kChordTooShort,  ///< The ends are closer than BasicArc::kShortestChord.
  kSweepTooLarge,  ///< One of the arcs would turn by more than half a turn.
};

/// Where a curve begins and ends, and which way it goes there.
template <typename Scalar>
struct BasicBiarcEnds {
  BasicVec2<Scalar> start;
  BasicVec2<Scalar> start_tangent;  ///< Unit vector.
  BasicVec2<Scalar> end;
  BasicVec2<Scalar> end_tangent;  ///< Unit vector.
};
using BiarcEnds = BasicBiarcEnds<float>;
using WideBiarcEnds = BasicBiarcEnds<double>;

/// Two arcs that meet at `joint` with one tangent, as bulges (see Arc).
template <typename Scalar>
struct BasicBiarc {
  BasicVec2<Scalar> joint;
  BasicVec2<Scalar> joint_tangent;  ///< Unit vector.
  Scalar first_bulge;
  Scalar second_bulge;
};
using Biarc = BasicBiarc<float>;
using WideBiarc = BasicBiarc<double>;

/// The two arcs through both ends with both tangents; of the family of them
/// the one whose joint lies at `joint_share` on the circle of all joints.
///
/// With the angles a and b from the chord to the start and end tangent, in
/// (−π, π], and w = (b − a) / 2: all joints lie on the arc from start to end
/// with half sweep w (Bolton, CAD 7 (1975) 29). At the share s of it the half
/// sweeps are −a − (1 − s) w and b − s w, the chords
/// L sin(s w) / sin w and L sin((1 − s) w) / sin w. Nothing divides by a
/// difference of tangents, so C shapes, S shapes, parallel tangents (w = 0), a
/// lone arc (a = −b) and a line are one case.
///
/// Of two ways to turn from one end tangent to the other the one that turns by
/// less relative to the chord is taken; none with loops.
///
/// Guarantee: the tangents at both ends and at the joint are met within
/// kBiarcTangentError radians, the joint lies within kBiarcJointError · L of
/// the exact one; in double precision within kWideBiarcError of both.
/// @param joint_share 0…1 without the ends.
inline constexpr double kBiarcTangentError = 2.0e-6;
inline constexpr double kBiarcJointError = 2.0e-6;
inline constexpr double kWideBiarcError = 2.0e-14;
[[nodiscard]] Result<Biarc, BiarcError> make_biarc(const BiarcEnds& ends, float joint_share);
[[nodiscard]] Result<WideBiarc, BiarcError> make_biarc(const WideBiarcEnds& ends,
                                                       double joint_share);

/// The bulge of the arc over `chord` that begins in the direction `tangent`; with
/// the two exchanged, of the arc that ends so. For at most half a turn, so in
/// −1…1: beyond that meaningless but bounded. 0 where one of the two is null.
[[nodiscard]] float bulge_between(const Vec2& tangent, const Vec2& chord);
[[nodiscard]] double wide_bulge_between(const WideVec2& tangent, const WideVec2& chord);

}  // namespace cnc

#pragma once

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc.hpp"
#include "planner/geometry/biarc.hpp"

/// Formulas that biarc.cpp and wide_biarc.cpp instantiate. Each of these sources supplies the
/// functions and limits of its precision. They are separate, so that a controller image contains no
/// double arithmetic.
namespace cnc::biarc_formulas {

/// Returns sin(share · angle) / sin(angle), or `share` itself if the angle is close to 0.
template <typename Numbers, typename Scalar>
Scalar sine_share(Scalar share, Scalar angle, Scalar sine) {
  if (std::abs(angle) < Numbers::kSmallAngle) return share;
  return sin_cos(share * angle).sine / sine;
}

/// Returns the bulge of a half sweep. Near 0 it has the relative precision of the half sweep.
template <typename Scalar>
Scalar bulge_of(Scalar half_sweep) {
  const auto half = sin_cos(Scalar{0.5F} * half_sweep);
  return half.sine / half.cosine;
}

template <typename Scalar>
BasicVec2<Scalar> turned(const BasicVec2<Scalar>& v, const BasicSinCos<Scalar>& by) {
  return by.cosine * v + by.sine * left_normal(v);
}

template <typename Scalar>
Scalar bulge_of_tangent(const BasicVec2<Scalar>& tangent, const BasicVec2<Scalar>& chord) {
  // Computes tan(h / 2) = sin h / (1 + cos h), where h is the angle between the two vectors.
  const Scalar sine = cross(tangent, chord);
  const Scalar both = std::sqrt(tangent.squaredNorm() * chord.squaredNorm());
  const Scalar denominator = both + std::max(Scalar{0}, tangent.dot(chord));
  return denominator > Scalar{0} ? std::clamp(sine / denominator, Scalar{-1}, Scalar{1})
                                 : Scalar{0};
}

template <typename Numbers, typename Scalar>
Result<BasicBiarc<Scalar>, BiarcError> biarc_at(const BasicBiarcEnds<Scalar>& ends,
                                                Scalar joint_share) {
  const auto angle_between = [](const BasicVec2<Scalar>& from, const BasicVec2<Scalar>& to) {
    return Numbers::angle_of(cross(from, to), from.dot(to));
  };
  const BasicVec2<Scalar> chord = ends.end - ends.start;
  constexpr Scalar kShortest{BasicArc<Scalar>::kShortestChord.in_mm_and_s()};
  if (chord.norm() < kShortest) return BiarcError::kChordTooShort;
  const Scalar a = angle_between(chord, ends.start_tangent);
  const Scalar b = angle_between(chord, ends.end_tangent);
  const Scalar w = Scalar{0.5F} * (b - a);
  if (std::abs(w) > Numbers::kWidest) return BiarcError::kSweepTooLarge;
  const Scalar first_sweep = -a - (Scalar{1} - joint_share) * w;
  const Scalar second_sweep = b - joint_share * w;
  if (!(std::abs(first_sweep) <= Numbers::kQuarterTurn &&
        std::abs(second_sweep) <= Numbers::kQuarterTurn)) {
    return BiarcError::kSweepTooLarge;
  }
  const Scalar length = sine_share<Numbers>(joint_share, w, sin_cos(w).sine);
  const auto first_chord = sin_cos(-(Scalar{1} - joint_share) * w);
  const auto first_turn = sin_cos(Scalar{2} * first_sweep);
  return BasicBiarc<Scalar>{.joint = ends.start + length * turned(chord, first_chord),
                            .joint_tangent = turned(ends.start_tangent, first_turn),
                            .first_bulge = bulge_of(first_sweep),
                            .second_bulge = bulge_of(second_sweep)};
}

}  // namespace cnc::biarc_formulas

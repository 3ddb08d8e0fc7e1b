#include "planner/geometry/biarc.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc.hpp"

namespace cnc {
namespace {

/// Below it the sine is its angle to the last bit of a float, but for 1e-9; of a double, but for
/// 1e-17.
constexpr float small_angle(float /*of*/) { return 1.0e-4F; }
constexpr double small_angle(double /*of*/) { return 1.0e-8; }

/// Beyond, both arcs are half turns without end.
constexpr float widest(float /*of*/) { return kPi - 1.0e-3F; }
constexpr double widest(double /*of*/) { return 3.14159265358979323846 - 1.0e-6; }

constexpr float quarter_turn(float /*of*/) { return kHalfPi; }
constexpr double quarter_turn(double /*of*/) { return 1.57079632679489661923; }

float angle_of(float y, float x) { return atan2_f(y, x); }
double angle_of(double y, double x) { return atan2_d(y, x); }

/// sin(share · angle) / sin(angle), the share itself as the angle vanishes.
template <typename Scalar>
Scalar sine_share(Scalar share, Scalar angle, Scalar sine) {
  if (std::abs(angle) < small_angle(Scalar{})) return share;
  return sin_cos(share * angle).sine / sine;
}

/// From the half sweep; as precise near 0 as the sweep is.
template <typename Scalar>
Scalar bulge_of(Scalar half_sweep) {
  const auto half = sin_cos(Scalar(0.5) * half_sweep);
  return half.sine / half.cosine;
}

template <typename Scalar>
BasicVec2<Scalar> turned(const BasicVec2<Scalar>& v, const BasicSinCos<Scalar>& by) {
  return by.cosine * v + by.sine * left_normal(v);
}

template <typename Scalar>
Scalar angle_between(const BasicVec2<Scalar>& from, const BasicVec2<Scalar>& to) {
  return angle_of(cross(from, to), from.dot(to));
}

template <typename Scalar>
Scalar bulge_of_tangent(const BasicVec2<Scalar>& tangent, const BasicVec2<Scalar>& chord) {
  // tan(h / 2) = sin h / (1 + cos h), with h the angle between the two.
  const Scalar sine = cross(tangent, chord);
  const Scalar both = std::sqrt(tangent.squaredNorm() * chord.squaredNorm());
  const Scalar denominator = both + std::max(Scalar(0), tangent.dot(chord));
  return denominator > Scalar(0) ? std::clamp(sine / denominator, Scalar(-1), Scalar(1))
                                 : Scalar(0);
}

template <typename Scalar>
Result<BasicBiarc<Scalar>, BiarcError> biarc_at(const BasicBiarcEnds<Scalar>& ends,
                                                Scalar joint_share) {
  const BasicVec2<Scalar> chord = ends.end - ends.start;
  if (chord.norm() < Scalar(Arc::kShortestChord.in_mm_and_s())) return BiarcError::kChordTooShort;
  const Scalar a = angle_between(chord, ends.start_tangent);
  const Scalar b = angle_between(chord, ends.end_tangent);
  const Scalar w = Scalar(0.5) * (b - a);
  if (std::abs(w) > widest(Scalar{})) return BiarcError::kSweepTooLarge;
  const Scalar first_sweep = -a - (Scalar(1) - joint_share) * w;
  const Scalar second_sweep = b - joint_share * w;
  const Scalar most = quarter_turn(Scalar{});
  if (!(std::abs(first_sweep) <= most && std::abs(second_sweep) <= most)) {
    return BiarcError::kSweepTooLarge;
  }
  const Scalar length = sine_share(joint_share, w, sin_cos(w).sine);
  const auto first_chord = sin_cos(-(Scalar(1) - joint_share) * w);
  const auto first_turn = sin_cos(Scalar(2) * first_sweep);
  return BasicBiarc<Scalar>{.joint = ends.start + length * turned(chord, first_chord),
                            .joint_tangent = turned(ends.start_tangent, first_turn),
                            .first_bulge = bulge_of(first_sweep),
                            .second_bulge = bulge_of(second_sweep)};
}

}  // namespace

float bulge_between(const Vec2& tangent, const Vec2& chord) {
  return bulge_of_tangent(tangent, chord);
}

template <typename Scalar>
Scalar bulge_between(const BasicVec2<Scalar>& tangent, const BasicVec2<Scalar>& chord) {
  return bulge_of_tangent(tangent, chord);
}
template double bulge_between(const Vec2D&, const Vec2D&);

Result<Biarc, BiarcError> make_biarc(const BiarcEnds& ends, float joint_share) {
  return biarc_at(ends, joint_share);
}

template <typename Scalar>
Result<BasicBiarc<Scalar>, BiarcError> make_biarc(const BasicBiarcEnds<Scalar>& ends,
                                                  Scalar joint_share) {
  return biarc_at(ends, joint_share);
}
template Result<BasicBiarc<double>, BiarcError> make_biarc(const BasicBiarcEnds<double>&, double);

}  // namespace cnc

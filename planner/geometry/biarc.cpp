#include "planner/geometry/biarc.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc.hpp"

namespace cnc {
namespace {

/// Below this the sine is its angle to the last bit of a float, but for 1e-9.
constexpr float kSmallAngle = 1.0e-4F;

/// sin(share · angle) / sin(angle), the share itself as the angle vanishes.
float sine_share(float share, float angle, float sine) {
  if (std::abs(angle) < kSmallAngle) return share;
  return sin_cos(share * angle).sine / sine;
}

/// From the half sweep; as precise near 0 as the sweep is.
float bulge_of(float half_sweep) {
  const SinCos half = sin_cos(0.5F * half_sweep);
  return half.sine / half.cosine;
}

Vec2 turned(const Vec2& v, const SinCos& by) { return by.cosine * v + by.sine * left_normal(v); }

float angle_between(const Vec2& from, const Vec2& to) {
  return atan2_f(cross(from, to), from.dot(to));
}

}  // namespace

float bulge_between(const Vec2& tangent, const Vec2& chord) {
  // tan(h / 2) = sin h / (1 + cos h), with h the angle between the two.
  const float sine = cross(tangent, chord);
  const float both = std::sqrt(tangent.squaredNorm() * chord.squaredNorm());
  const float denominator = both + std::max(0.0F, tangent.dot(chord));
  return denominator > 0.0F ? std::clamp(sine / denominator, -1.0F, 1.0F) : 0.0F;
}

Result<Biarc, BiarcError> make_biarc(const BiarcEnds& ends, float joint_share) {
  constexpr float kWidest = kPi - 1.0e-3F;  // Beyond, both arcs are half turns without end.
  const Vec2 chord = ends.end - ends.start;
  if (chord.norm() < Arc::kShortestChord.in_mm_and_s()) return BiarcError::kChordTooShort;
  const float a = angle_between(chord, ends.start_tangent);
  const float b = angle_between(chord, ends.end_tangent);
  const float w = 0.5F * (b - a);
  if (std::abs(w) > kWidest) return BiarcError::kSweepTooLarge;
  const float first_sweep = -a - (1.0F - joint_share) * w;
  const float second_sweep = b - joint_share * w;
  if (!(std::abs(first_sweep) <= kHalfPi && std::abs(second_sweep) <= kHalfPi)) {
    return BiarcError::kSweepTooLarge;
  }
  const float length = sine_share(joint_share, w, sin_cos(w).sine);
  const SinCos first_chord = sin_cos(-(1.0F - joint_share) * w);
  return Biarc{.joint = ends.start + length * turned(chord, first_chord),
               .joint_tangent = turned(ends.start_tangent, sin_cos(2.0F * first_sweep)),
               .first_bulge = bulge_of(first_sweep),
               .second_bulge = bulge_of(second_sweep)};
}

}  // namespace cnc

#include "planner/geometry/arc.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc {

Result<Arc, ArcError> Arc::make(const Vec2& start, const Vec2& end, float bulge) {
  if ((end - start).norm() < kShortestChord.in_mm_and_s()) return ArcError::kChordTooShort;
  if (!(std::abs(bulge) <= kLargestBulge)) return ArcError::kSweepTooLarge;
  return Arc{start, end, bulge};
}

float Arc::curvature() const {
  const float chord = (end_ - start_).norm();
  return 4.0F * bulge_ / (chord * (1.0F + bulge_ * bulge_));
}

float Arc::half_sweep() const {
  const float size = std::abs(bulge_);
  const float half = size > 1.0F ? kPi - 2.0F * atan_unit(1.0F / size) : 2.0F * atan_unit(size);
  return bulge_ < 0.0F ? -half : half;
}

Length Arc::length() const {
  const float chord = (end_ - start_).norm();
  const float b = std::abs(bulge_);
  // chord * (1 + b²) * atan(b) / b; the quotient tends to 1, and atan(b) / b
  // loses digits once b² drops below float epsilon, so switch to its series.
  const float quotient = b < 1.0e-2F ? 1.0F - b * b / 3.0F : 0.5F * std::abs(half_sweep()) / b;
  return Length{chord * (1.0F + b * b) * quotient};
}

// The tangents lead and trail the chord by half the sweep.
Vec2 Arc::chord_turned_by_half_sweep(float direction) const {
  const Vec2 chord = (end_ - start_).normalized();
  const float scale = 1.0F / (1.0F + bulge_ * bulge_);
  const float cosine = (1.0F - bulge_ * bulge_) * scale;
  const float sine = direction * 2.0F * bulge_ * scale;
  return cosine * chord + sine * left_normal(chord);
}

Vec2 Arc::start_tangent() const { return chord_turned_by_half_sweep(-1.0F); }

Vec2 Arc::end_tangent() const { return chord_turned_by_half_sweep(1.0F); }

Arc Arc::reversed() const { return Arc{end_, start_, -bulge_}; }

}  // namespace cnc

#include "planner/geometry/arc.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc {

template <std::floating_point Scalar>
Result<BasicArc<Scalar>, ArcError> BasicArc<Scalar>::make(const Vector& start,
                                                          const Vector& end,
                                                          Scalar bulge) {
  if ((end - start).norm() < Scalar{kShortestChord.in_mm_and_s()}) return ArcError::kChordTooShort;
  if (!(std::abs(bulge) <= kLargestBulge)) return ArcError::kSweepTooLarge;
  return BasicArc{start, end, bulge};
}

template <std::floating_point Scalar>
Scalar BasicArc<Scalar>::curvature() const {
  const Scalar chord = (end_ - start_).norm();
  return Scalar{4} * bulge_ / (chord * (Scalar{1} + bulge_ * bulge_));
}

template <std::floating_point Scalar>
Scalar BasicArc<Scalar>::half_sweep() const requires std::same_as<Scalar, float> {
  const float size = std::abs(bulge_);
  const float half = size > 1.0F ? kPi - 2.0F * atan_unit(1.0F / size) : 2.0F * atan_unit(size);
  return bulge_ < 0.0F ? -half : half;
}

template <std::floating_point Scalar>
Length BasicArc<Scalar>::length() const requires std::same_as<Scalar, float> {
  const float chord = (end_ - start_).norm();
  const float b = std::abs(bulge_);
  // chord * (1 + b²) * atan(b) / b; the quotient tends to 1, and atan(b) / b
  // loses digits once b² drops below float epsilon, so switch to its series.
  const float quotient = b < 1.0e-2F ? 1.0F - b * b / 3.0F : 0.5F * std::abs(half_sweep()) / b;
  return Length{chord * (1.0F + b * b) * quotient};
}

// The tangents lead and trail the chord by half the sweep.
template <std::floating_point Scalar>
typename BasicArc<Scalar>::Vector BasicArc<Scalar>::chord_turned_by_half_sweep(
    Scalar direction) const {
  const Vector chord = (end_ - start_).normalized();
  const Scalar scale = Scalar{1} / (Scalar{1} + bulge_ * bulge_);
  const Scalar cosine = (Scalar{1} - bulge_ * bulge_) * scale;
  const Scalar sine = direction * Scalar{2} * bulge_ * scale;
  return cosine * chord + sine * left_normal(chord);
}

template <std::floating_point Scalar>
typename BasicArc<Scalar>::Vector BasicArc<Scalar>::start_tangent() const {
  return chord_turned_by_half_sweep(Scalar{-1});
}

template <std::floating_point Scalar>
typename BasicArc<Scalar>::Vector BasicArc<Scalar>::end_tangent() const {
  return chord_turned_by_half_sweep(Scalar{1});
}

template <std::floating_point Scalar>
BasicArc<Scalar> BasicArc<Scalar>::reversed() const {
  return BasicArc{end_, start_, -bulge_};
}

template class BasicArc<float>;
template class BasicArc<double>;

}  // namespace cnc

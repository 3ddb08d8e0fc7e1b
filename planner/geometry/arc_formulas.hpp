#pragma once

#include <cmath>

#include "planner/geometry/arc.hpp"

/// Definitions that arc.cpp and wide_arc.cpp instantiate. These two sources are separate, so that
/// an image with arcs in single precision contains no double arithmetic.
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

// At each end the direction of the chord differs from the tangent by half the sweep.
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

}  // namespace cnc

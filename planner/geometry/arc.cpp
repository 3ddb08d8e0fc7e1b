#include "planner/geometry/arc.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc_formulas.hpp"

namespace cnc {

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
  // length = chord · (1 + b²) · atan(b) / b. The quotient atan(b) / b tends to 1, but its
  // computation loses digits when b² is below float epsilon, so its series is used for small b.
  const float quotient = b < 1.0e-2F ? 1.0F - b * b / 3.0F : 0.5F * std::abs(half_sweep()) / b;
  return Length{chord * (1.0F + b * b) * quotient};
}

template class BasicArc<float>;

}  // namespace cnc

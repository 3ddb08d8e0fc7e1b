#include "tests/planner/contour/ellipse_curve.hpp"

#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/base/wide_scalar_math.hpp"

namespace cnc::contour {

EllipseCurve::EllipseCurve(const Ellipse& ellipse) : ellipse_{ellipse} {
  constexpr double kSpan = 0.78539816339744831 * (1.0 + 1.0e-12);
  const double sweep = std::abs(ellipse.end - ellipse.start);
  CNC_ASSERT(sweep > 0.0 && sweep <= kWideSinCosRange);
  span_count_ = static_cast<std::size_t>(std::ceil(sweep / kSpan));
}

CurveJet EllipseCurve::at(std::size_t span, double share) const {
  CNC_ASSERT(span < span_count_);
  const double rate = (ellipse_.end - ellipse_.start) / static_cast<double>(span_count_);
  const double angle = ellipse_.start + rate * (static_cast<double>(span) + share);
  const auto [sine, cosine] = sin_cos(angle);
  CurveJet jet{};
  const WideVec2 outward = cosine * ellipse_.major + sine * ellipse_.minor;
  jet.place = ellipse_.centre + outward;
  jet.first = rate * (cosine * ellipse_.minor - sine * ellipse_.major);
  jet.second = (-rate * rate) * outward;
  return jet;
}

}  // namespace cnc::contour

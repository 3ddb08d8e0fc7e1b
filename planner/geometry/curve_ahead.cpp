#include "planner/geometry/curve_ahead.hpp"

#include <algorithm>

namespace cnc {
namespace {

struct Value {
  float value;
  float slope;  ///< By the degree.
};

/// De Casteljau's triangle. Not in powers of the parameter: with unequal weights
/// those cancel each other.
Value evaluate(std::array<float, Bezier::kHighestDegree + 1> c, std::size_t degree, float t) {
  const float rest = 1.0F - t;
  for (std::size_t last = degree; last > 1; --last) {
    for (std::size_t i = 0; i < last; ++i) c[i] = rest * c[i] + t * c[i + 1];
  }
  return {.value = rest * c[0] + t * c[1], .slope = c[1] - c[0]};
}

}  // namespace

float CurveAhead::length() const {
  const std::size_t left = spline_->segment_count() - segment_;
  return static_cast<float>(std::min(left, kMostPieces)) - parameter_;
}

CurveAhead::Spot CurveAhead::spot(float distance) const {
  const float first = 1.0F - parameter_;
  if (distance <= first) return {0, distance >= first ? 1.0F : distance / first};
  const float further = distance - first;
  const std::size_t last = std::min(spline_->segment_count() - segment_, kMostPieces) - 1;
  const std::size_t piece = std::min(static_cast<std::size_t>(further) + 1, last);
  return {piece, std::min(further - static_cast<float>(piece - 1), 1.0F)};
}

float CurveAhead::expressible(float distance) const {
  const float sum = parameter_ + distance;
  return std::min(sum - parameter_, length());
}

void CurveAhead::look() {
  prepared_ = 0;
  if (at_end()) {
    const ControlPoint& last = spline_->point(spline_->size() - 1);
    origin_ = last.place;
    return;
  }
  beziers_[0] = spline_->segment(segment_).from(parameter_);
  origin_ = segment_ == 0 && parameter_ <= 0.0F ? PlanePlace{} : beziers_[0].start();
  const Vec2 tangent = beziers_[0].start_tangent();
  if (tangent.squaredNorm() > 0.0F) tangent_ = tangent;
  hulls_[0] = seen_from_here(beziers_[0]);
  prepared_ = 1;
}

void CurveAhead::prepare(std::size_t piece) {
  for (; prepared_ <= piece; ++prepared_) {
    beziers_[prepared_] = spline_->segment(segment_ + prepared_);
    hulls_[prepared_] = seen_from_here(beziers_[prepared_]);
  }
}

CurveAhead::Hull CurveAhead::seen_from_here(const Bezier& bezier) const {
  const Wide here_x = to_wide(origin_.x);
  const Wide here_y = to_wide(origin_.y);
  const Wide along_x{tangent_.x()};
  const Wide along_y{tangent_.y()};
  Hull seen;
  for (std::size_t i = 0; i <= bezier.degree(); ++i) {
    const WeightedPoint& point = bezier.point(i);
    const Wide dx = point.x - point.weight * here_x;
    const Wide dy = point.y - point.weight * here_y;
    seen.x[i] = (dx * along_x + dy * along_y).to_float() * kMillimetresPerNanometre;
    seen.y[i] = (dy * along_x - dx * along_y).to_float() * kMillimetresPerNanometre;
    seen.weight[i] = point.weight.to_float();
  }
  return seen;
}

CurvePoint CurveAhead::at(float distance) {
  const Spot where = spot(distance);
  prepare(where.piece);
  const Hull& hull = hulls_[where.piece];
  const std::size_t degree = spline_->order() - 1;
  const Value x = evaluate(hull.x, degree, where.parameter);
  const Value y = evaluate(hull.y, degree, where.parameter);
  const Value weight = evaluate(hull.weight, degree, where.parameter);
  const float share = 1.0F / weight.value;
  const Vec2 place{x.value * share, y.value * share};
  return {.place = place,
          .direction = {x.slope - place.x() * weight.slope, y.slope - place.y() * weight.slope}};
}

Vec2 CurveAhead::arrival(float distance) {
  const Spot where = spot(distance);
  prepare(where.piece);
  const Bezier& bezier = beziers_[where.piece];
  const bool whole = where.parameter >= 1.0F;
  const Vec2 tangent = whole ? bezier.end_tangent() : bezier.until(where.parameter).end_tangent();
  if (tangent.squaredNorm() <= 0.0F) return {1.0F, 0.0F};
  return {tangent.dot(tangent_), cross(tangent_, tangent)};
}

void CurveAhead::advance(float distance) {
  float parameter = parameter_ + distance;
  if (distance >= length()) {
    segment_ += std::min(spline_->segment_count() - segment_, kMostPieces);
    parameter = 0.0F;
  }
  while (parameter >= 1.0F) {  // At most kMostPieces times.
    parameter -= 1.0F;
    ++segment_;
  }
  parameter_ = parameter;
  look();
}

}  // namespace cnc

#include "planner/geometry/curve_ahead.hpp"

#include <algorithm>

namespace cnc {

float CurveAhead::length() const {
  const std::size_t left = spline_->segment_count() - segment_;
  return static_cast<float>(std::min(left, kMaxPieces)) - parameter_;
}

CurveAhead::Spot CurveAhead::spot(float distance) const {
  const float first = 1.0F - parameter_;
  if (distance <= first) return {0, distance >= first ? 1.0F : distance / first};
  const float further = distance - first;
  const std::size_t last = std::min(spline_->segment_count() - segment_, kMaxPieces) - 1;
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
  views_[0] = BezierView{beziers_[0], origin_, tangent_};
  prepared_ = 1;
}

void CurveAhead::prepare(std::size_t piece) {
  for (; prepared_ <= piece; ++prepared_) {
    beziers_[prepared_] = spline_->segment(segment_ + prepared_);
    views_[prepared_] = BezierView{beziers_[prepared_], origin_, tangent_};
  }
}

CurvePoint CurveAhead::at(float distance) {
  const Spot where = spot(distance);
  prepare(where.piece);
  return views_[where.piece].at(where.parameter);
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
    segment_ += std::min(spline_->segment_count() - segment_, kMaxPieces);
    parameter = 0.0F;
  }
  while (parameter >= 1.0F) {  // This repeats at most kMaxPieces times.
    parameter -= 1.0F;
    ++segment_;
  }
  parameter_ = parameter;
  look();
}

}  // namespace cnc

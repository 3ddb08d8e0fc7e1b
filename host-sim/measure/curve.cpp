#include "host-sim/measure/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host-sim/measure/helix_distance.hpp"

namespace sim {

Point operator-(const Point& a, const Point& b) {
  Point difference{};
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  return difference;
}

double dot(const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double norm(const Point& a) { return std::sqrt(dot(a, a)); }

double distance(const Point& a, const Point& b) { return norm(a - b); }

Curve Curve::line(const Point& start, const Point& end) {
  Curve made{start, end};
  made.length_ = distance(start, end);
  return made;
}

Curve Curve::arc(const Point& start,
                 const Point& end,
                 cnc::Plane plane,
                 const std::array<double, 2>& centre,
                 bool clockwise) {
  const auto [first, second, normal] = cnc::axes_of(plane);
  const double half_x = (end[first] - start[first]) / 2.0;
  const double half_y = (end[second] - start[second]) / 2.0;
  const double half_chord = std::hypot(half_x, half_y);
  const double middle_x = start[first] + half_x;
  const double middle_y = start[second] + half_y;
  // How far the centre stands to the left of the chord.
  const double height =
      ((centre[1] - middle_y) * half_x - (centre[0] - middle_x) * half_y) / half_chord;
  const double turn = clockwise ? -1.0 : 1.0;

  Circle circle{.plane = plane};
  circle.centre = {middle_x - height * half_y / half_chord,
                   middle_y + height * half_x / half_chord};
  circle.radius = std::hypot(half_chord, height);
  circle.start_angle =
      std::atan2(start[second] - circle.centre[1], start[first] - circle.centre[0]);
  circle.sweep = turn * 2.0 * std::atan2(half_chord, turn * height);

  Curve made{start, end};
  made.circle_ = circle;
  made.length_ = std::hypot(circle.radius * circle.sweep, made.straight_length());
  return made;
}

double Curve::straight_length() const {
  const auto axes = cnc::axes_of(circle_->plane);
  Point run = end_ - start_;
  run[axes.first] = run[axes.second] = 0.0;
  return norm(run);
}

double Curve::linear_length() const {
  const Point run = end_ - start_;
  if (!circle_) return std::hypot(run[0], run[1], run[2]);
  return std::hypot(circle_->radius * circle_->sweep, run[cnc::axes_of(circle_->plane).normal]);
}

Point Curve::point_at(double fraction) const {
  if (fraction <= 0.0) return start_;
  if (fraction >= 1.0) return end_;
  Point point{};
  for (std::size_t i = 0; i < point.size(); ++i) {
    point[i] = start_[i] + fraction * (end_[i] - start_[i]);
  }
  if (circle_) {
    const auto axes = cnc::axes_of(circle_->plane);
    const double angle = circle_->start_angle + fraction * circle_->sweep;
    point[axes.first] = circle_->centre[0] + circle_->radius * std::cos(angle);
    point[axes.second] = circle_->centre[1] + circle_->radius * std::sin(angle);
  }
  return point;
}

Point Curve::tangent_at(double fraction) const {
  if (length_ <= 0.0) return {};
  Point tangent = end_ - start_;
  for (double& component : tangent) component /= length_;
  if (circle_) {
    const auto axes = cnc::axes_of(circle_->plane);
    const double angle = circle_->start_angle + fraction * circle_->sweep;
    const double rate = circle_->radius * circle_->sweep / length_;
    tangent[axes.first] = -rate * std::sin(angle);
    tangent[axes.second] = rate * std::cos(angle);
  }
  return tangent;
}

Point Curve::curvature_at(double fraction) const {
  Point curvature{};
  if (!circle_ || length_ <= 0.0) return curvature;
  const auto axes = cnc::axes_of(circle_->plane);
  const double angle = circle_->start_angle + fraction * circle_->sweep;
  const double turn = circle_->sweep / length_;
  curvature[axes.first] = -circle_->radius * turn * turn * std::cos(angle);
  curvature[axes.second] = -circle_->radius * turn * turn * std::sin(angle);
  return curvature;
}

Bounds Curve::bounds() const {
  Bounds bounds{start_, start_};
  const auto include = [&bounds](const Point& point) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      bounds.low[i] = std::min(bounds.low[i], point[i]);
      bounds.high[i] = std::max(bounds.high[i], point[i]);
    }
  };
  include(end_);
  if (!circle_) return bounds;
  // The circle's four extremes lie at whole quarter turns.
  const double quarter = std::numbers::pi / 2.0;
  const double from = std::min(0.0, circle_->sweep) + circle_->start_angle;
  const double to = std::max(0.0, circle_->sweep) + circle_->start_angle;
  for (double turn = std::ceil(from / quarter); turn * quarter < to; turn += 1.0) {
    include(point_at((turn * quarter - circle_->start_angle) / circle_->sweep));
  }
  return bounds;
}

Nearest Curve::measured(const Point& to, double fraction) const {
  const Point point = point_at(fraction);
  return {fraction, distance(to, point), point};
}

Nearest Curve::nearest(const Point& to, double from) const {
  if (length_ <= 0.0) return measured(to, 1.0);
  if (circle_) return measured(to, nearest_fraction_on_arc(to, from));
  const double along = dot(to - start_, end_ - start_) / (length_ * length_);
  return measured(to, std::clamp(along, from, 1.0));
}

double Curve::nearest_fraction_on_arc(const Point& to, double from) const {
  const auto axes = cnc::axes_of(circle_->plane);
  const double x = to[axes.first] - circle_->centre[0];
  const double y = to[axes.second] - circle_->centre[1];
  const double sweep = std::abs(circle_->sweep);
  const double turn = circle_->sweep < 0.0 ? -1.0 : 1.0;
  // The angle travelled to the point, counted from the middle of what is left.
  const double middle = sweep * (from + 1.0) / 2.0;
  const double travelled =
      middle + std::remainder(turn * (std::atan2(y, x) - circle_->start_angle) - middle,
                              2.0 * std::numbers::pi);
  HelixDistance helix{.radius = circle_->radius,
                      .sweep = sweep,
                      .point_radius = std::hypot(x, y),
                      .point_angle = travelled};
  Point run = end_ - start_;
  run[axes.first] = run[axes.second] = 0.0;
  helix.run_squared = dot(run, run);
  if (helix.run_squared == 0.0) return std::clamp(travelled / sweep, from, 1.0);
  helix.run_offset = dot(run, start_ - to);
  Point beside = start_ - to;
  beside[axes.first] = beside[axes.second] = 0.0;
  helix.offset_squared = dot(beside, beside);
  return helix.nearest_fraction(from);
}

}  // namespace sim

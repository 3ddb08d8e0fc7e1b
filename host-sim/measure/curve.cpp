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

PlaneVectors::PlaneVectors(const cnc::ArcPlane& plane) {
  const cnc::PlaneFrame frame = plane.frame();
  std::copy(frame.first.begin(), frame.first.end(), first_.begin());
  std::copy(frame.second.begin(), frame.second.end(), second_.begin());
  if (!plane.oblique()) return;
  // The vectors of the arc's frame are unit vectors and perpendicular only to single precision.
  const double size = norm(first_);
  for (double& share : first_) share /= size;
  const double along = dot(first_, second_);
  for (std::size_t i = 0; i < second_.size(); ++i) second_[i] -= along * first_[i];
  const double across = norm(second_);
  for (double& share : second_) share /= across;
}

std::array<double, 2> PlaneVectors::seen(const Point& vector) const {
  return {dot(vector, first_), dot(vector, second_)};
}

Point PlaneVectors::off(const Point& vector) const { return vector - this->vector(seen(vector)); }

Point PlaneVectors::vector(const std::array<double, 2>& seen) const {
  Point vector{};
  for (std::size_t i = 0; i < vector.size(); ++i) {
    vector[i] = seen[0] * first_[i] + seen[1] * second_[i];
  }
  return vector;
}

Curve Curve::line(const Point& start, const Point& end) {
  Curve made{start, end};
  made.length_ = distance(start, end);
  return made;
}

Curve Curve::arc(const Point& start,
                 const Point& end,
                 const cnc::ArcPlane& plane,
                 const std::array<double, 2>& centre,
                 bool clockwise) {
  Circle circle{.plane = plane, .vectors = PlaneVectors{plane}};
  const auto [start_x, start_y] = circle.vectors.seen(start);
  const auto [end_x, end_y] = circle.vectors.seen(end);
  const double half_x = (end_x - start_x) / 2.0;
  const double half_y = (end_y - start_y) / 2.0;
  const double half_chord = std::hypot(half_x, half_y);
  const double middle_x = start_x + half_x;
  const double middle_y = start_y + half_y;
  // Distance of the centre to the left of the chord.
  const double height =
      ((centre[1] - middle_y) * half_x - (centre[0] - middle_x) * half_y) / half_chord;
  const double turn = clockwise ? -1.0 : 1.0;

  circle.centre = {middle_x - height * half_y / half_chord,
                   middle_y + height * half_x / half_chord};
  circle.radius = std::hypot(half_chord, height);
  circle.start_angle = std::atan2(start_y - circle.centre[1], start_x - circle.centre[0]);
  circle.sweep = turn * 2.0 * std::atan2(half_chord, turn * height);

  Curve made{start, end};
  made.circle_ = circle;
  made.length_ = std::hypot(circle.radius * circle.sweep, norm(made.run_off_plane()));
  return made;
}

Point Curve::run_off_plane() const { return circle_->vectors.off(end_ - start_); }

/// Returns the length along X Y Z. For an arc with rotary axes in its plane, it is a share of the
/// arc's length: the share of the chord's length that is along X Y Z.
double Curve::linear_length() const {
  const Point run = end_ - start_;
  if (!circle_) return std::hypot(run[0], run[1], run[2]);
  const Point off_plane = run_off_plane();
  const Point chord = run - off_plane;
  const double share =
      circle_->plane.oblique() ? std::hypot(chord[0], chord[1], chord[2]) / norm(chord) : 1.0;
  return std::hypot(circle_->radius * circle_->sweep * share,
                    std::hypot(off_plane[0], off_plane[1], off_plane[2]));
}

std::array<double, 2> Curve::outward_at(double fraction) const {
  const double angle = circle_->start_angle + fraction * circle_->sweep;
  return {std::cos(angle), std::sin(angle)};
}

Point Curve::point_at(double fraction) const {
  if (fraction <= 0.0) return start_;
  if (fraction >= 1.0) return end_;
  const Point run = circle_ ? run_off_plane() : end_ - start_;
  Point point = circle_ ? circle_->vectors.off(start_) : start_;
  for (std::size_t i = 0; i < point.size(); ++i) point[i] += fraction * run[i];
  if (!circle_) return point;
  const auto [cosine, sine] = outward_at(fraction);
  const Point round = circle_->vectors.vector(
      {circle_->centre[0] + circle_->radius * cosine, circle_->centre[1] + circle_->radius * sine});
  for (std::size_t i = 0; i < point.size(); ++i) point[i] += round[i];
  return point;
}

Point Curve::tangent_at(double fraction) const {
  if (length_ <= 0.0) return {};
  Point tangent = circle_ ? run_off_plane() : end_ - start_;
  for (double& component : tangent) component /= length_;
  if (!circle_) return tangent;
  const auto [cosine, sine] = outward_at(fraction);
  const double rate = circle_->radius * circle_->sweep / length_;
  const Point round = circle_->vectors.vector({-rate * sine, rate * cosine});
  for (std::size_t i = 0; i < tangent.size(); ++i) tangent[i] += round[i];
  return tangent;
}

Point Curve::curvature_at(double fraction) const {
  if (!circle_ || length_ <= 0.0) return {};
  const auto [cosine, sine] = outward_at(fraction);
  const double turn = circle_->sweep / length_;
  const double bend = circle_->radius * turn * turn;
  return circle_->vectors.vector({-bend * cosine, -bend * sine});
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
  // The two extremes of an axis are half a turn apart. In a coordinate plane, they are at multiples
  // of a quarter turn.
  const double from = std::min(0.0, circle_->sweep) + circle_->start_angle;
  const double to = std::max(0.0, circle_->sweep) + circle_->start_angle;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    if (!circle_->plane.has(axis)) continue;
    const double outermost =
        std::atan2(circle_->vectors.second()[axis], circle_->vectors.first()[axis]);
    for (double half = std::ceil((from - outermost) / std::numbers::pi);
         outermost + half * std::numbers::pi < to;
         half += 1.0) {
      const double angle = outermost + half * std::numbers::pi;
      include(point_at((angle - circle_->start_angle) / circle_->sweep));
    }
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
  const auto [seen_x, seen_y] = circle_->vectors.seen(to);
  const double x = seen_x - circle_->centre[0];
  const double y = seen_y - circle_->centre[1];
  const double sweep = std::abs(circle_->sweep);
  const double turn = circle_->sweep < 0.0 ? -1.0 : 1.0;
  // The angle from the start to the point in the direction of travel, within half a turn of the
  // middle of the remaining sweep.
  const double middle = sweep * (from + 1.0) / 2.0;
  const double travelled =
      middle + std::remainder(turn * (std::atan2(y, x) - circle_->start_angle) - middle,
                              2.0 * std::numbers::pi);
  HelixDistance helix{.radius = circle_->radius,
                      .sweep = sweep,
                      .point_radius = std::hypot(x, y),
                      .point_angle = travelled};
  const Point run = run_off_plane();
  helix.run_squared = dot(run, run);
  if (helix.run_squared == 0.0) return std::clamp(travelled / sweep, from, 1.0);
  helix.run_offset = dot(run, start_ - to);
  const Point beside = circle_->vectors.off(start_ - to);
  helix.offset_squared = dot(beside, beside);
  return helix.nearest_fraction(from);
}

}  // namespace sim

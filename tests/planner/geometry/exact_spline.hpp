#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "planner/geometry/path_element.hpp"
#include "planner/geometry/spline.hpp"

namespace cnc::exact {

/// Vectors of the plane in double precision, mm.
struct Vector {
  double x = 0.0;
  double y = 0.0;
  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }
};
inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
inline double norm(Vector a) { return std::sqrt(dot(a, a)); }
inline double distance(Vector a, Vector b) { return norm(a - b); }
/// Returns the unsigned angle, 0…π.
inline double angle_between(Vector a, Vector b) {
  return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

/// A NURBS by the definition of its basis functions (Cox and de Boor), which the product does not
/// use. The parameter is in 0…segments().
class ExactSpline {
 public:
  explicit ExactSpline(const Spline& spline) : order_{spline.order()} {
    for (std::size_t i = 0; i < spline.size(); ++i) {
      const ControlPoint& point = spline.point(i);
      points_.push_back({1.0e-6 * static_cast<double>(point.place.x),
                         1.0e-6 * static_cast<double>(point.place.y)});
      weights_.push_back(static_cast<double>(point.weight));
    }
    const auto segments = static_cast<double>(spline.segment_count());
    for (std::size_t i = 0; i < points_.size() + order_; ++i) {
      const double inner = static_cast<double>(i) - static_cast<double>(order_ - 1);
      knots_.push_back(std::clamp(inner, 0.0, segments));
    }
  }

  [[nodiscard]] double segments() const { return knots_.back(); }
  [[nodiscard]] Vector at(double u) const { return value(u, 0); }
  /// Returns the direction, with any length; zero at a cusp.
  [[nodiscard]] Vector direction_at(double u) const { return value(u, 1); }

 private:
  [[nodiscard]] Vector value(double u, int derivative) const {
    const auto degree = order_ - 1;
    const auto last = static_cast<std::size_t>(segments()) - 1;
    const std::size_t span = std::min(static_cast<std::size_t>(std::max(0.0, u)), last);
    const std::vector<double> b = basis(u, span, order_);
    const std::vector<double> lower = basis(u, span, degree);
    Vector sum{};
    Vector slope{};
    double weight = 0.0;
    double weight_slope = 0.0;
    for (std::size_t j = 0; j <= degree; ++j) {
      const std::size_t i = span + j;
      double rate = 0.0;
      if (j > 0) rate += lower[j - 1] / (knots_[i + degree] - knots_[i]);
      if (j < degree) rate -= lower[j] / (knots_[i + degree + 1] - knots_[i + 1]);
      rate *= static_cast<double>(degree);
      sum = sum + (b[j] * weights_[i]) * points_[i];
      slope = slope + (rate * weights_[i]) * points_[i];
      weight += b[j] * weights_[i];
      weight_slope += rate * weights_[i];
    }
    const Vector place = (1.0 / weight) * sum;
    if (derivative == 0) return place;
    return (1.0 / weight) * (slope - weight_slope * place);
  }

  /// Returns the `order` functions that are not zero in the span. The first one belongs to control
  /// point span + order_ − order.
  [[nodiscard]] std::vector<double> basis(double u, std::size_t span, std::size_t order) const {
    const std::size_t knot = span + order_ - 1;  // Here, knots_[knot] ≤ u ≤ knots_[knot + 1].
    std::vector<double> b{1.0};
    for (std::size_t k = 2; k <= order; ++k) {
      std::vector<double> next(k, 0.0);
      for (std::size_t j = 0; j < b.size(); ++j) {
        const std::size_t i = knot + 1 + j - b.size();
        const double left = knots_[i];
        const double right = knots_[i + k - 1];
        const double share = (u - left) / (right - left);
        next[j] += (1.0 - share) * b[j];
        next[j + 1] += share * b[j];
      }
      b = next;
    }
    return b;
  }

  std::size_t order_;
  std::vector<Vector> points_;
  std::vector<double> weights_;
  std::vector<double> knots_;
};

/// An element of a chain, by its exact ends and bulge.
class ExactArc {
 public:
  ExactArc(const PathElement& element, const Position& origin)
      : start_{from(element.start, origin)},
        end_{from(element.end, origin)},
        bulge_{static_cast<double>(element.bulge)} {}

  [[nodiscard]] double chord() const { return distance(start_, end_); }
  [[nodiscard]] Vector start_tangent() const { return turned(-2.0 * std::atan(bulge_)); }
  [[nodiscard]] Vector end_tangent() const { return turned(2.0 * std::atan(bulge_)); }
  [[nodiscard]] Vector start() const { return start_; }
  [[nodiscard]] Vector end() const { return end_; }

  [[nodiscard]] Vector at(double share) const {
    // Chords turn by half the angle: r = sin(h s) / sin h at the angle −h (1 − s).
    const double h = 2.0 * std::atan(bulge_);
    const double along = std::abs(h) < 1.0e-12 ? share : std::sin(h * share) / std::sin(h);
    return start_ + along * rotate(end_ - start_, -h * (1.0 - share));
  }

  [[nodiscard]] double distance_to(Vector q) const {
    const double ends = std::min(distance(q, start_), distance(q, end_));
    if (chord() <= 0.0) return ends;
    if (std::abs(bulge_) < 1.0e-9) {
      const Vector along = end_ - start_;
      const double share = std::clamp(dot(q - start_, along) / dot(along, along), 0.0, 1.0);
      return distance(q, start_ + share * along);
    }
    const double h = 2.0 * std::atan(bulge_);
    const double radius = chord() / (2.0 * std::sin(h));  // Signed radius.
    const Vector t = start_tangent();
    const Vector centre = start_ + radius * Vector{-t.y, t.x};
    const Vector inwards_start = (radius > 0.0 ? 1.0 : -1.0) * (start_ - centre);
    const Vector inwards_q = (radius > 0.0 ? 1.0 : -1.0) * (q - centre);
    double turn = std::atan2(cross(inwards_start, inwards_q), dot(inwards_start, inwards_q));
    if (h < 0.0) turn = -turn;
    if (turn < 0.0 || turn > 2.0 * std::abs(h)) return ends;
    return std::abs(distance(q, centre) - std::abs(radius));
  }

 private:
  static Vector from(const Position& place, const Position& origin) {
    return {1.0e-6 * static_cast<double>((place[0] - origin[0]).nanometres()),
            1.0e-6 * static_cast<double>((place[1] - origin[1]).nanometres())};
  }
  static Vector rotate(Vector v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
  }
  [[nodiscard]] Vector turned(double angle) const {
    const double length = chord();
    return length > 0.0 ? rotate((1.0 / length) * (end_ - start_), angle) : Vector{};
  }

  Vector start_;
  Vector end_;
  double bulge_;
};

}  // namespace cnc::exact

#pragma once

#include <cmath>
#include <numbers>

#include "planner/geometry/vector.hpp"

namespace sim::drawing {

/// A point or a vector in the plane of a drawing: mm, y upwards.
using Place = cnc::WideVec2;

inline constexpr double kFullTurn = 2.0 * std::numbers::pi;

[[nodiscard]] inline double cross(const Place& a, const Place& b) {
  return a.x() * b.y() - a.y() * b.x();
}
[[nodiscard]] inline double dot(const Place& a, const Place& b) {
  return a.x() * b.x() + a.y() * b.y();
}
[[nodiscard]] inline double distance(const Place& a, const Place& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}
[[nodiscard]] inline bool is_finite(const Place& place) {
  return std::isfinite(place.x()) && std::isfinite(place.y());
}
[[nodiscard]] inline Place direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// An affine map, stored as the images of the unit vectors along x and y, and of the origin.
struct Transform {
  Place x_axis{1.0, 0.0};
  Place y_axis{0.0, 1.0};
  Place origin{0.0, 0.0};

  [[nodiscard]] Place way(const Place& w) const { return x_axis * w.x() + y_axis * w.y(); }
  [[nodiscard]] Place operator()(const Place& p) const { return origin + way(p); }
  [[nodiscard]] double determinant() const { return cross(x_axis, y_axis); }

  /// Returns whether the map keeps circles as circles, to one part in 10⁹.
  [[nodiscard]] bool keeps_circles() const {
    const double size = x_axis.squaredNorm() + y_axis.squaredNorm();
    return std::abs(x_axis.squaredNorm() - y_axis.squaredNorm()) <= 1.0e-9 * size &&
           std::abs(dot(x_axis, y_axis)) <= 1.0e-9 * size;
  }
  [[nodiscard]] bool finite() const {
    return is_finite(x_axis) && is_finite(y_axis) && is_finite(origin);
  }
};

/// Returns the map that applies first `inner`, then `outer`.
[[nodiscard]] inline Transform operator*(const Transform& outer, const Transform& inner) {
  return {outer.way(inner.x_axis), outer.way(inner.y_axis), outer(inner.origin)};
}

[[nodiscard]] inline Transform moved_by(const Place& way) { return {.origin = way}; }
[[nodiscard]] inline Transform scaled_by(double x, double y) {
  return {.x_axis{x, 0.0}, .y_axis{0.0, y}};
}
[[nodiscard]] inline Transform turned_by(double angle) {
  const Place x = direction(angle);
  return {.x_axis = x, .y_axis{-x.y(), x.x()}};
}

}  // namespace sim::drawing

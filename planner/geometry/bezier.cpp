#include "planner/geometry/bezier.hpp"

#include <cmath>

namespace cnc {
namespace {

/// Returns the vector between two control points after division by their weights, nm.
Vec2 difference(const WeightedPoint& from, const WeightedPoint& to) {
  const Wide ratio = to.weight / from.weight;
  return {(to.x - ratio * from.x).to_float() / to.weight.to_float(),
          (to.y - ratio * from.y).to_float() / to.weight.to_float()};
}

}  // namespace

WeightedPoint between(const WeightedPoint& a, const WeightedPoint& b, const Wide& share) {
  return {.x = a.x + share * (b.x - a.x),
          .y = a.y + share * (b.y - a.y),
          .weight = a.weight + share * (b.weight - a.weight)};
}

Bezier Bezier::until(float parameter) const {
  const Wide share{parameter};
  Bezier part = *this;
  for (std::size_t round = 1; round <= degree_; ++round) {
    for (std::size_t i = degree_; i >= round; --i) {
      part.points_[i] = between(part.points_[i - 1], part.points_[i], share);
    }
  }
  return part;
}

Bezier Bezier::from(float parameter) const {
  const Wide share{parameter};
  Bezier part = *this;
  for (std::size_t round = 1; round <= degree_; ++round) {
    for (std::size_t i = 0; i + round <= degree_; ++i) {
      part.points_[i] = between(part.points_[i], part.points_[i + 1], share);
    }
  }
  return part;
}

Vec2 Bezier::start_tangent() const {
  for (std::size_t i = 1; i <= degree_; ++i) {
    const Vec2 along = difference(points_[0], points_[i]);
    const float length = along.norm();
    if (length > kCoincident) return along / length;
  }
  return {0.0F, 0.0F};
}

Vec2 Bezier::end_tangent() const {
  for (std::size_t i = degree_; i-- > 0;) {
    const Vec2 along = -difference(points_[degree_], points_[i]);
    const float length = along.norm();
    if (length > kCoincident) return along / length;
  }
  return {0.0F, 0.0F};
}

PlanePlace Bezier::place_of(const WeightedPoint& point) {
  return {.x = nearest_whole(point.x / point.weight), .y = nearest_whole(point.y / point.weight)};
}

}  // namespace cnc

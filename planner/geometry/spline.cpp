#include "planner/geometry/spline.hpp"

namespace cnc {
namespace {

WeightedPoint weighted(const ControlPoint& point) {
  const Wide weight{point.weight};
  return {
      .x = weight * to_wide(point.place.x), .y = weight * to_wide(point.place.y), .weight = weight};
}

}  // namespace

float Spline::knot(std::size_t index) const {
  const std::size_t degree = order_ - 1;
  if (index <= degree) return 0.0F;
  const std::size_t inner = index - degree;
  return static_cast<float>(inner < segment_count() ? inner : segment_count());
}

/// Evaluates a blossom by De Boor's triangle, with a separate argument in each round.
WeightedPoint Spline::blossom(std::size_t segment, std::size_t times_end) const {
  const std::size_t degree = order_ - 1;
  std::array<WeightedPoint, kHighestOrder> d{};
  for (std::size_t i = 0; i <= degree; ++i) d[i] = weighted(points_[segment + i]);
  for (std::size_t round = 1; round <= degree; ++round) {
    const auto argument = static_cast<float>(segment + (round <= times_end ? 1 : 0));
    for (std::size_t i = degree; i >= round; --i) {
      const float left = knot(segment + i);
      const float right = knot(segment + i + degree + 1 - round);
      const Wide share = Wide{argument - left} / Wide{right - left};
      d[i] = between(d[i - 1], d[i], share);
    }
  }
  return d[degree];
}

Bezier Spline::segment(std::size_t index) const {
  CNC_ASSERT(complete() && index < segment_count());
  std::array<WeightedPoint, kHighestOrder> points{};
  for (std::size_t i = 0; i < order_; ++i) points[i] = blossom(index, i);
  return Bezier{points, order_ - 1};
}

}  // namespace cnc

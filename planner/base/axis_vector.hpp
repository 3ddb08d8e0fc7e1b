#pragma once

#include <cmath>

#include "planner/base/coordinate.hpp"

namespace cnc {

/// A vector in the Euclidean space of all axes: mm along X Y Z, degrees along A B C.
using AxisVector = AxisArray<float>;

/// Returns the vector from one position to another. Each component is rounded once.
[[nodiscard]] inline AxisVector travel_between(const Position& from, const Position& to) {
  AxisVector way{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) way[axis] = (to[axis] - from[axis]).mm();
  return way;
}

/// Returns a position after it was moved by a vector, to the nearest nanometre on each axis.
[[nodiscard]] inline Position moved_by(const Position& from, const AxisVector& way) {
  Position place = from;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) place[axis] += from_mm(way[axis]);
  return place;
}

[[nodiscard]] inline float dot(const AxisVector& a, const AxisVector& b) {
  float sum = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) sum += a[axis] * b[axis];
  return sum;
}

[[nodiscard]] inline float norm(const AxisVector& vector) { return std::sqrt(dot(vector, vector)); }

/// Returns a + share · b.
[[nodiscard]] inline AxisVector sum_of(const AxisVector& a, float share, const AxisVector& b) {
  AxisVector sum = a;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) sum[axis] += share * b[axis];
  return sum;
}

[[nodiscard]] inline AxisVector scaled(float share, const AxisVector& vector) {
  AxisVector product = vector;
  for (float& part : product) part *= share;
  return product;
}

}  // namespace cnc

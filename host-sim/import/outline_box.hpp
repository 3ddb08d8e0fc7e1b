#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "host-sim/import/place.hpp"

namespace sim::drawing {

/// The smallest rectangle around points, with sides along the axes. It is empty until a point is
/// included.
struct OutlineBox {
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Place least{kInfinite, kInfinite};
  Place most{-kInfinite, -kInfinite};

  void include(const Place& place) {
    least = least.cwiseMin(place);
    most = most.cwiseMax(place);
  }
  [[nodiscard]] double width() const { return most.x() - least.x(); }
  [[nodiscard]] double height() const { return most.y() - least.y(); }
  [[nodiscard]] bool around(const OutlineBox& other) const {
    return least.x() <= other.least.x() && least.y() <= other.least.y() &&
           most.x() >= other.most.x() && most.y() >= other.most.y();
  }
};

[[nodiscard]] inline OutlineBox box_of(std::span<const Place> places) {
  OutlineBox box;
  for (const Place& place : places) box.include(place);
  return box;
}

}  // namespace sim::drawing

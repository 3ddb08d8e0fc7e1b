#pragma once

#include "host-sim/import/curve.hpp"

namespace sim::drawing {

/// A length, mm, or an area, mm², with the position at which it was measured.
struct Extent {
  double size = 0.0;
  Place place{0.0, 0.0};

  void take_greater(double other_size, const Place& other_place) {
    if (other_size <= size) return;
    size = other_size;
    place = other_place;
  }
};

}  // namespace sim::drawing

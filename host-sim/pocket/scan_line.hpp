#pragma once

#include <vector>

#include "host-sim/pocket/owned_area.hpp"

namespace sim::pocket {

/// A stretch of a line along X.
struct Stretch {
  double from_x = 0.0;
  double to_x = 0.0;  ///< Greater.
};

/// A side of a stretch, or of an area seen along X.
enum class Side : std::uint8_t { kLeft, kRight };

[[nodiscard]] inline double end_of(const Stretch& stretch, Side side) {
  return side == Side::kLeft ? stretch.from_x : stretch.to_x;
}

/// Returns the stretches of the line at a height Y that lie in an area, from left to right. Where
/// the line only touches the boundary, the stretch goes on.
[[nodiscard]] std::vector<Stretch> stretches_at(const OwnedArea& area, double y);

/// Returns a box around an area. @pre it has an element
[[nodiscard]] cnc::contour::FlatBox<double> box_of(const OwnedArea& area);

}  // namespace sim::pocket

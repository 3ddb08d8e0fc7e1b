#pragma once

#include <vector>

#include "host-sim/pocket/owned_area.hpp"

namespace sim::pocket {

/// A stretch of a line that is parallel to X.
struct Stretch {
  double from_x = 0.0;
  double to_x = 0.0;  ///< Greater than `from_x`.
};

/// One side of a stretch, or of an area, along X.
enum class Side : std::uint8_t { kLeft, kRight };

[[nodiscard]] inline double end_of(const Stretch& stretch, Side side) {
  return side == Side::kLeft ? stretch.from_x : stretch.to_x;
}

/// Returns the stretches of a line along X at the Y coordinate `y` that are in an area, from left
/// to right. A point where the line only touches the boundary does not divide a stretch.
[[nodiscard]] std::vector<Stretch> stretches_at(const OwnedArea& area, double y);

/// Returns a box around an area. @pre the area has an element
[[nodiscard]] cnc::contour::FlatBox<double> box_of(const OwnedArea& area);

}  // namespace sim::pocket

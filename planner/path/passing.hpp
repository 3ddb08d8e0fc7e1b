#pragma once

#include "planner/geometry/path_element.hpp"

namespace cnc::path {

/// The point of an element that is nearest to a position.
struct Passing {
  Position place{};
  /// Length of the element before the point as a share of its whole length, 0…1.
  float share = 0.0F;
  float distance_mm = 0.0F;
};

/// Returns the point of an element that is nearest to a position. On an arc or a helix, it is
/// computed from chords in the plane. For a position on the arc, the error is 1e-5 of the arc's
/// length. For a position off the arc, the error along the arc is at most the distance of the
/// position from the arc. For an element that does not move, the result is its end.
[[nodiscard]] Passing passing_of(const PathElement& element, const Position& place);

}  // namespace cnc::path

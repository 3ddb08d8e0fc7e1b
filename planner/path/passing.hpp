#pragma once

#include "planner/geometry/path_element.hpp"

namespace cnc::path {

/// The point of an element that is nearest to a position.
struct Passing {
  Position place{};
  float share = 0.0F;  ///< Share of the element's length before the point, 0…1.
  float distance_mm = 0.0F;
};

/// Returns the point of an element nearest to a position. On an arc or a helix it is computed from
/// chords in the plane. For positions on the arc the error is 1e-5 of its length. For positions off
/// the arc, the result is off along the arc by at most their distance from it. For an element that
/// does not move, the result is its end.
[[nodiscard]] Passing passing_of(const PathElement& element, const Position& place);

}  // namespace cnc::path

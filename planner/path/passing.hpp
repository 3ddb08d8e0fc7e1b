#pragma once

#include "planner/geometry/path_element.hpp"

namespace cnc::path {

/// The place on an element that is nearest to another place.
struct Passing {
  Position place{};
  float share = 0.0F;  ///< Of the element's length before it, 0…1.
  float distance_mm = 0.0F;
};

/// Of an arc or a helix by its chords in its plane: for places on it to 1e-5 of its length, beside
/// it off along the arc by at most as much as they lie beside it. Where nothing moves it is the
/// end.
[[nodiscard]] Passing passing_of(const PathElement& element, const Position& place);

}  // namespace cnc::path

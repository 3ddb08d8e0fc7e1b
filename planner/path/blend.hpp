#pragma once

#include <array>
#include <cstddef>

#include "planner/path/corner.hpp"

namespace cnc::path {

/// The arcs that round a corner.
struct Blend {
  std::array<PathElement, 2> parts{};
  std::size_t count = 0;
};

/// Returns the blend from a position on one leg to a position on the other, with the tangents that
/// the legs have there. Between straight legs it is one arc. Next to a curved leg, or where the two
/// halves belong to different elements, it is two arcs. They meet smoothly at the point nearest the
/// corner, each in its own plane.
/// @param trim_mm distance of both positions from the corner, along the legs.
[[nodiscard]] Blend make_blend(
    const Corner& corner, const Position& from, const Position& to, float trim_mm, bool in_halves);

/// Shortens an element to its part between two positions on it.
/// @param share length of that part as a share of the element's length, 0…1.
void become_part(PathElement& element, const Position& from, const Position& to, float share);

}  // namespace cnc::path

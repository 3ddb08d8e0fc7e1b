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

/// From one place on a leg to the one on the other, with the tangents that the
/// legs have there. Between straight legs one arc; beside a curved one, or where
/// the halves belong to different elements, two that meet smoothly at the
/// place nearest the corner, each in a plane of its own.
/// @param trim_mm how far both places are from the corner, along the legs.
[[nodiscard]] Blend make_blend(
    const Corner& corner, const Position& from, const Position& to, float trim_mm, bool in_halves);

/// Leaves of an element what lies between two places on it.
/// @param share of its length, 0…1.
void become_part(PathElement& element, const Position& from, const Position& to, float share);

}  // namespace cnc::path

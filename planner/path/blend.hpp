#pragma once

#include <array>
#include <cstddef>

#include "planner/path/corner.hpp"

namespace cnc::path {

/// The one or two arcs that replace a corner.
struct Blend {
  std::array<PathElement, 2> parts{};
  std::size_t count = 0;
};

/// Returns the blend from a position on one leg to a position on the other leg. At its ends, it has
/// the tangents of the legs. Between straight legs, it is one arc. If a leg is curved, or with
/// `in_halves`, it is two arcs, each in its own plane. They join smoothly at the point nearest the
/// corner.
/// @param trim_mm distance of both positions from the corner along the legs, mm
/// @param in_halves whether the halves of the blend belong to different elements
[[nodiscard]] Blend make_blend(
    const Corner& corner, const Position& from, const Position& to, float trim_mm, bool in_halves);

/// Shortens an element to its part between two positions on it.
/// @param share length of that part as a share of the element's length, 0…1
void become_part(PathElement& element, const Position& from, const Position& to, float share);

}  // namespace cnc::path

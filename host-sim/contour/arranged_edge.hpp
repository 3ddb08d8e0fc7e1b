#pragma once

#include <cstdint>
#include <vector>

#include "planner/contour/offset_space.hpp"

namespace sim {

/// Number of times that a loop runs around a point counter-clockwise. A list of these is in the
/// order of the loops and has no entry with 0 turns.
struct LoopTurns {
  std::uint32_t loop = 0;
  int turns = 0;
};
using Windings = std::vector<LoopTurns>;

/// A loop that runs along an edge.
struct EdgeOwner {
  std::uint32_t loop = 0;
  /// Number of times that the loop runs from the edge's start to its end.
  std::uint32_t along = 0;
  /// Number of times that the loop runs from the edge's end to its start.
  std::uint32_t against = 0;

  /// Returns by how much the loop's turns on the left of the edge exceed those on its right.
  [[nodiscard]] int step() const { return static_cast<int>(along) - static_cast<int>(against); }
};

/// A line or an arc between two nodes, where loops cross, touch or leave each other, or where
/// elements of a loop join. Loops on top of each other have one edge.
struct ArrangedEdge {
  std::uint32_t raw = 0;  ///< The element of which the edge is a part.
  std::uint32_t from_node = 0;
  std::uint32_t to_node = 0;
  std::uint32_t first_owner = 0;  ///< First owner of the edge in the list of all owners.
  std::uint32_t end_owner = 0;
  std::uint32_t left = cnc::contour::kNone;  ///< Number of the windings on the left of the edge.
  std::uint32_t right = cnc::contour::kNone;
};

/// An edge of an arrangement. The flag says whether a loop that is written runs against the edge.
struct DirectedEdge {
  std::uint32_t edge = 0;
  bool is_reversed = false;
};

}  // namespace sim

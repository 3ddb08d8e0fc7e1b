#pragma once

#include <cstdint>
#include <vector>

#include "planner/contour/offset_space.hpp"

namespace sim {

/// The winding number of a loop around a point: how often it turns around the point
/// counter-clockwise. Lists of LoopTurns are in the order of the loop numbers and have no entries
/// with 0 turns.
struct LoopTurns {
  std::uint32_t loop = 0;
  int turns = 0;
};
using Windings = std::vector<LoopTurns>;

/// A loop that runs along an edge, once or more often.
struct EdgeOwner {
  std::uint32_t loop = 0;
  /// Number of times that the loop runs from the edge's start to its end.
  std::uint32_t along = 0;
  /// Number of times that the loop runs from the edge's end to its start.
  std::uint32_t against = 0;

  /// Returns the winding number of the loop on the left of the edge, minus that on the right.
  [[nodiscard]] int step() const { return static_cast<int>(along) - static_cast<int>(against); }
};

/// A line or an arc between two nodes. A node is a point where loops cross, touch or separate, or
/// where elements of a loop join. Loops that run along the same path share one edge.
struct ArrangedEdge {
  std::uint32_t raw = 0;  ///< Number of the element of which the edge is a part.
  std::uint32_t from_node = 0;
  std::uint32_t to_node = 0;
  /// Index of the first owner of the edge in the list of all owners.
  std::uint32_t first_owner = 0;
  std::uint32_t end_owner = 0;
  std::uint32_t left = cnc::contour::kNone;  ///< Index of the windings on the left of the edge.
  std::uint32_t right = cnc::contour::kNone;
};

/// An edge of an arrangement, given by its number. `is_reversed` is true if the loop to be written
/// runs from the end of the edge to its start.
struct DirectedEdge {
  std::uint32_t edge = 0;
  bool is_reversed = false;
};

}  // namespace sim

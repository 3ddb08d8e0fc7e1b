#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "host-sim/surface/path/plan_grid.hpp"

namespace sim::surface {

/// Side of a line of equal value on which a node of a grid lies.
enum class NodeSide : std::uint8_t {
  kLow,   ///< The node's value is at or below the value of the line.
  kHigh,  ///< The node's value is above the value of the line.
  kNone,  ///< The node has no value: lines end before it.
};

/// An edge of a grid that a line crosses, given by its two nodes.
struct CrossedEdge {
  std::size_t low = 0;
  std::size_t high = 0;
};

/// A line between low and high nodes, given by the edges that it crosses, in order. The high nodes
/// are on its right.
struct IsoLine {
  std::vector<CrossedEdge> edges;
  bool is_closed = false;  ///< Whether the last edge leads to the first, which is not repeated.
};

/// Returns all lines of a grid: closed lines, and lines that end at the border or before a node
/// without a value. Each edge between a low and a high node is crossed by one line.
/// @param side_of returns the side of a node, given by its number
/// @param has_high_middle returns whether a cell, given by the number of its first node, is high in
/// its middle; it is called for cells whose corners are alternately high and low
[[nodiscard]] std::vector<IsoLine> iso_lines(
    const PlanGrid& grid,
    const std::function<NodeSide(std::size_t)>& side_of,
    const std::function<bool(std::size_t)>& has_high_middle);

}  // namespace sim::surface

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "host-sim/surface/path/plan_grid.hpp"

namespace sim::surface {

/// Side on which a node of a grid is, relative to a line of equal value.
enum class NodeSide : std::uint8_t {
  kLow,   ///< The node's value is at or below the value of the line.
  kHigh,  ///< The node's value is above the value of the line.
  kNone,  ///< The node has no value. Lines end before such a node.
};

/// An edge of a grid that a line crosses, given by its two nodes.
struct CrossedEdge {
  std::size_t low = 0;
  std::size_t high = 0;
};

/// A line of equal value, given by the edges that it crosses, in order. The high nodes are on the
/// right of the line.
struct IsoLine {
  std::vector<CrossedEdge> edges;
  /// Whether the line returns from the last edge to the first edge, which is not repeated.
  bool is_closed = false;
};

/// Returns all lines of equal value on a grid: closed lines, and open lines that end at the border
/// or before a node without a value. One line crosses each edge between a low and a high node.
/// @param side_of returns the side of a node, given by its number
/// @param has_high_middle returns whether a cell, given by the number of its first node, is high in
/// its middle. It is called for cells whose corners are alternately high and low
[[nodiscard]] std::vector<IsoLine> iso_lines(
    const PlanGrid& grid,
    const std::function<NodeSide(std::size_t)>& side_of,
    const std::function<bool(std::size_t)>& has_high_middle);

}  // namespace sim::surface

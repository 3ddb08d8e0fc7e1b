#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "host-sim/surface/path/plan_grid.hpp"

namespace sim::surface {

/// A node of a grid, seen from a line of one value.
enum class NodeSide : std::uint8_t {
  kLow,   ///< At the value or below.
  kHigh,  ///< Above.
  kNone,  ///< Without a value: lines end before it.
};

/// An edge of a grid that a line crosses, by its two nodes.
struct CrossedEdge {
  std::size_t low = 0;
  std::size_t high = 0;
};

/// A line between low and high nodes, as the edges that it crosses in order, with the high nodes
/// on its right.
struct IsoLine {
  std::vector<CrossedEdge> edges;
  bool is_closed = false;  ///< The last edge leads to the first, which is not repeated.
};

/// Returns all lines of a grid: closed ones, and those that end at the border or before a node
/// without a value. Each edge between a low and a high node is crossed by one line.
/// @param side_of of a node by its number
/// @param has_high_middle whether a cell, by the number of its first node, is high in its middle;
/// called where its corners are high and low in turn
[[nodiscard]] std::vector<IsoLine> iso_lines(
    const PlanGrid& grid,
    const std::function<NodeSide(std::size_t)>& side_of,
    const std::function<bool(std::size_t)>& has_high_middle);

}  // namespace sim::surface

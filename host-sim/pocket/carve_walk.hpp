#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/pocket/carve_piece.hpp"

namespace sim::pocket {

/// One piece in the order of driving.
struct WalkStep {
  std::size_t piece = 0;
  bool is_reversed = false;  ///< Whether the piece is driven from `to` to `from`.
  bool is_return = false;    ///< Whether the piece was driven before, so that it has no stock.
  bool begins_row = false;   ///< Whether the tool is lifted before the piece.
};

/// Returns an order in which every piece is cut once. The tool continues at the node where it is.
/// If all pieces of that node are cut, the tool returns along cut pieces to a node with uncut
/// pieces. The return is at most `return_limit_mm` long. If no such node is in reach, the tool is
/// lifted and continues at another node: if possible at a node with an odd number of uncut pieces,
/// and where distance plus radius is least. At each node, dead ends of at most `return_limit_mm`
/// come first, then pieces that continue, then longer dead ends.
///
/// Source: an Euler trail where the graph has one. Time: number of pieces times number of rows.
[[nodiscard]] std::vector<WalkStep> walk_along(const CarveGraph& graph, double return_limit_mm);

}  // namespace sim::pocket

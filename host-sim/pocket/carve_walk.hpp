#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/pocket/carve_piece.hpp"

namespace sim::pocket {

/// A piece that is driven along.
struct WalkStep {
  std::size_t piece = 0;
  bool is_reversed = false;  ///< From `to` to `from`.
  bool is_return = false;    ///< Driven before: the stock is gone.
  bool begins_row = false;   ///< The tool is lifted before it.
};

/// Returns an order in which every piece is cut once. The tool goes on at the node where it is, or
/// returns along pieces that it has cut, up to `return_limit_mm`, to one where something is left;
/// else it is lifted and goes on at the nearest node, at one with an odd number of pieces left if
/// possible, and the less deep the better. Dead ends are cut before longer ways.
///
/// Source: an Euler trail where the graph has one. Time: pieces times rows.
[[nodiscard]] std::vector<WalkStep> walk_along(const CarveGraph& graph, double return_limit_mm);

}  // namespace sim::pocket

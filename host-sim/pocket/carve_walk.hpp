#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/pocket/carve_piece.hpp"

namespace sim::pocket {

/// A piece as it is driven.
struct WalkStep {
  std::size_t piece = 0;
  bool is_reversed = false;  ///< Whether it is driven from `to` to `from`.
  bool is_return = false;    ///< Whether it was driven before, so that its stock is gone.
  bool begins_row = false;   ///< Whether the tool is lifted before it.
};

/// Returns an order in which every piece is cut once. The tool continues at the node where it is.
/// Otherwise it returns along pieces that it has cut, up to `return_limit_mm`, to a node with
/// pieces left. Otherwise it is lifted and continues at another node: at one with an odd number of
/// pieces left if possible, and where distance plus radius is least. Dead ends are cut before
/// longer paths.
///
/// Source: an Euler trail where the graph has one. Time: number of pieces times number of rows.
[[nodiscard]] std::vector<WalkStep> walk_along(const CarveGraph& graph, double return_limit_mm);

}  // namespace sim::pocket

#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// Chooses with which facet each edge is tried under a tool, so that none is tried twice.
///
/// One between two facets that rise from it is not tried where the tool is smooth, as one of them
/// lets the tool be higher beside the edge. A tool with a point or a rim may touch such a valley
/// with that, and all its edges are tried.
///
/// @return for each facet, bit i: the edge from corner i to the next
[[nodiscard]] std::vector<std::uint8_t> tried_edges(const Mesh& mesh, bool tool_is_smooth);

}  // namespace sim::surface

#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// Chooses the facet with which each edge is tested for contact with a tool, so that no edge is
/// tested twice.
///
/// An edge is in a valley if both of its facets rise from it. For a smooth tool, such an edge is
/// not tested, because the tool touches one of the facets first. A tool with a point or a rim may
/// touch the edge in a valley. So all edges are tested for such a tool.
///
/// @return for each facet a set of bits; bit i stands for the edge from corner i to the next corner
[[nodiscard]] std::vector<std::uint8_t> tried_edges(const Mesh& mesh, bool tool_is_smooth);

}  // namespace sim::surface

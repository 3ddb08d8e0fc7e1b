#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// Chooses for each edge the facet with which it is tested under a tool, so that no edge is tested
/// twice.
///
/// An edge between two facets that rise from it is not tested if the tool is smooth: at such a
/// valley the tool touches one of the facets first. A tool with a point or a rim may touch the
/// valley with that point or rim, so that all edges are tested.
///
/// @return for each facet a set of bits; bit i stands for the edge from corner i to the next
[[nodiscard]] std::vector<std::uint8_t> tried_edges(const Mesh& mesh, bool tool_is_smooth);

}  // namespace sim::surface

#pragma once

#include <string>

#include "host-sim/surface/mesh.hpp"

namespace sim::wall {

/// Throws std::invalid_argument unless the mesh encloses a solid: each edge has the same number of
/// facets in both directions, the facets face outwards, and the volume is not 0. The message states
/// the file, the first edge without a matching facet, and a remedy.
/// @param name name of the file, for messages
/// @pre equal corners of the mesh are one point
void require_solid(const surface::Mesh& mesh, const std::string& name);

}  // namespace sim::wall

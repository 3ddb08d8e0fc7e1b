#pragma once

#include <string>

#include "host-sim/surface/mesh.hpp"

namespace sim::wall {

/// Throws std::invalid_argument unless the mesh encloses a solid: each edge has as many facets on
/// one side as on the other, its facets face outwards, and it has a volume. The message states the
/// file, the first edge with a facet on one side only, and a remedy.
/// @param name name of the file, for messages
/// @pre equal corners of the mesh are one point
void require_solid(const surface::Mesh& mesh, const std::string& name);

}  // namespace sim::wall

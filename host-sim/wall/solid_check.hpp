#pragma once

#include <string>

#include "host-sim/surface/mesh.hpp"

namespace sim::wall {

/// Throws std::invalid_argument unless the mesh encloses a solid: each edge has as many facets on
/// one side as on the other, its facets look outwards, and it has a volume. The message names the
/// file, the first edge with a facet on one side only, and a remedy.
/// @param name of the file @pre equal corners of the mesh are one point
void require_solid(const surface::Mesh& mesh, const std::string& name);

}  // namespace sim::wall

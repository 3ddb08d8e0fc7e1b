#pragma once

#include <string>

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// Returns a mesh as a binary PLY file (little-endian) in mm. Its coordinates are doubles, so that
/// no digit is lost.
[[nodiscard]] std::string ply_of(const Mesh& mesh);

}  // namespace sim::surface

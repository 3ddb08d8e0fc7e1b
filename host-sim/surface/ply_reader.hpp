#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/mesh_draft.hpp"

namespace sim::surface {

/// Reads the positions of `vertex` and the polygons of `face` from a PLY file. A polygon becomes a
/// fan of triangles from its first corner. Other properties and elements are skipped. Throws
/// std::invalid_argument.
[[nodiscard]] MeshDraft read_ply(std::string_view bytes, const std::string& name);

}  // namespace sim::surface

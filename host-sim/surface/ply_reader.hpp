#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/mesh_draft.hpp"

namespace sim::surface {

/// Reads a PLY file: the positions of `vertex` and the polygons of `face`, each as a fan from its
/// first corner. Other properties and elements are passed over. Throws std::invalid_argument.
[[nodiscard]] MeshDraft read_ply(std::string_view bytes, const std::string& name);

}  // namespace sim::surface

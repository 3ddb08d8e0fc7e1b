#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/mesh_draft.hpp"

namespace sim::surface {

/// Returns whether the number of bytes matches the number of facets in the header of a binary STL
/// file. The first word is not checked, because a binary file may begin with `solid`, too.
[[nodiscard]] bool has_length_of_stl(std::string_view bytes);

/// Reads a binary STL file. Equal corners become one point. Normals are ignored, because the order
/// of corners contains the same information. Throws std::invalid_argument if the length does not
/// match, or for NaN.
[[nodiscard]] MeshDraft read_binary_stl(std::string_view bytes, const std::string& name);

/// Reads an ASCII STL file. Equal corners become one point, and normals are ignored.
[[nodiscard]] MeshDraft read_ascii_stl(std::string_view text, const std::string& name);

}  // namespace sim::surface

#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/mesh_draft.hpp"

namespace sim::surface {

/// Returns whether the bytes have the length of a binary STL file that has their count of facets.
/// Its header may begin with `solid` like that of a text.
[[nodiscard]] bool has_length_of_stl(std::string_view bytes);

/// Reads a binary STL file. Equal corners become one point; normals are passed over, because the
/// order of corners says the same. Throws std::invalid_argument where the length does not fit, or
/// for NaN.
[[nodiscard]] MeshDraft read_binary_stl(std::string_view bytes, const std::string& name);

/// Reads an STL text so.
[[nodiscard]] MeshDraft read_ascii_stl(std::string_view text, const std::string& name);

}  // namespace sim::surface

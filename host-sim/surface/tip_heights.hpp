#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/mesh.hpp"
#include "planner/surface/profile.hpp"

namespace sim::surface {

/// Returns `X Y Z` with 17 digits for each place of a text: the height at which the tip of a tool
/// stands there when it touches, `nan` where nothing is under it; mm.
/// @param places `X Y` on each line, blanks or a comma between them; lines that begin with # and
/// blank ones do not count
/// @param name of them, for messages. Throws std::invalid_argument for what is no place.
/// @pre the mesh has facets
[[nodiscard]] std::string tip_heights(const Mesh& mesh,
                                      const cnc::surface::Profile& tool,
                                      std::string_view places,
                                      const std::string& name);

}  // namespace sim::surface

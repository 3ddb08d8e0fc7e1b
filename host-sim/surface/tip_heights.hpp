#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/mesh.hpp"
#include "planner/surface/profile.hpp"

namespace sim::surface {

/// Returns a line `X Y Z` in mm with 17 digits for each position of a text. Z is the height of the
/// tool's tip in contact with the mesh at X, Y; `nan` if nothing is under the tool.
/// @param places `X Y` on each line, separated by blanks or a comma; blank lines and lines that
/// begin with # are ignored
/// @param name name of the text `places`, for messages
/// Throws std::invalid_argument for a line that is not a position.
/// @pre the mesh has facets
[[nodiscard]] std::string tip_heights(const Mesh& mesh,
                                      const cnc::surface::Profile& tool,
                                      std::string_view places,
                                      const std::string& name);

}  // namespace sim::surface

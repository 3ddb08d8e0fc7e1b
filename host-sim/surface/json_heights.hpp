#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Reads `{"width": 3, "height": 2, "values": [1, 2, null, 4, 5, 6]}`: heights in the file's unit,
/// row by row, with null for a missing point. Throws std::invalid_argument.
[[nodiscard]] GridDraft read_json_heights(std::string_view text,
                                          const std::string& name,
                                          const ReadOptions& options);

}  // namespace sim::surface

#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Reads the rows of an XYZ text or CSV file. Points that are absent from a regular grid become
/// missing points of the draft. Throws std::invalid_argument for rows of unequal length that do not
/// match a regular grid.
[[nodiscard]] GridDraft read_xyz(std::string_view text,
                                 const std::string& name,
                                 const ReadOptions& options);

}  // namespace sim::surface

#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Reads the rows of an XYZ text or CSV file. Missing points of a regular grid become missing
/// points of the draft. Other rows of unequal length throw std::invalid_argument.
[[nodiscard]] GridDraft read_xyz(std::string_view text,
                                 const std::string& name,
                                 const ReadOptions& options);

}  // namespace sim::surface

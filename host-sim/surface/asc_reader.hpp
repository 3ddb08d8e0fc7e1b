#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Reads an ESRI ASCII grid: `ncols`, `nrows`, `xllcorner` or `xllcenter` and so for y, `cellsize`
/// or `dx` and `dy`, and `NODATA_value` (-9999 without it), in any order and letters; then the
/// heights of all cells, which stand at their middles. A pitch of the options replaces the cells'
/// size, and moves the first point of the last row to 0, 0. Throws std::invalid_argument.
[[nodiscard]] GridDraft read_asc(std::string_view text,
                                 const std::string& name,
                                 const ReadOptions& options);

}  // namespace sim::surface

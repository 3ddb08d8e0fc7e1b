#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Reads an ESRI ASCII grid. Its header has `ncols`, `nrows`, `xllcorner` or `xllcenter` (the same
/// for y), `cellsize` or `dx` and `dy`, and `NODATA_value` (default -9999). The keys may be in any
/// order and in capital or small letters. The heights of all cells follow. Each height belongs to
/// the middle of its cell. A pitch in the options replaces the cell size and moves the first point
/// of the last row to 0, 0. Throws std::invalid_argument.
[[nodiscard]] GridDraft read_asc(std::string_view text,
                                 const std::string& name,
                                 const ReadOptions& options);

}  // namespace sim::surface

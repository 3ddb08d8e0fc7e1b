#pragma once

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Checks a grid, repairs it where the options say so, and makes it and its triangles a surface.
/// Throws std::invalid_argument for what cannot be or is not repaired.
[[nodiscard]] SurfaceInput finished_grid(GridDraft draft, const ReadOptions& options);

}  // namespace sim::surface

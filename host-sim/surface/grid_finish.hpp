#pragma once

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Checks a grid and repairs it if the options require a repair. Returns the grid and its triangles
/// as a surface. Throws std::invalid_argument for a fault that cannot be repaired, and for a fault
/// whose repair the options do not allow.
[[nodiscard]] SurfaceInput finished_grid(GridDraft draft, const ReadOptions& options);

}  // namespace sim::surface

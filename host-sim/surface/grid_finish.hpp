#pragma once

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Checks a grid, repairs it if the options say so, and returns it with its triangles as a surface.
/// Throws std::invalid_argument for a fault that cannot be repaired, or that the options leave.
[[nodiscard]] SurfaceInput finished_grid(GridDraft draft, const ReadOptions& options);

}  // namespace sim::surface

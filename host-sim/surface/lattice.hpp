#pragma once

#include <optional>
#include <vector>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/scan_rows.hpp"

namespace sim::surface {

/// Fits a regular grid to the points of a table. Each point must be within a tenth of the pitch of
/// a grid point. The grid may be rotated in plan. Grid points without a point of the table become
/// missing points. Returns nothing if the points do not match a grid, if two points match the same
/// grid point, or if more than half of the grid points are missing.
[[nodiscard]] std::optional<GridDraft> lattice_of(const XyzTable& table,
                                                  const std::vector<ScanRow>& rows,
                                                  const std::string& name);

}  // namespace sim::surface

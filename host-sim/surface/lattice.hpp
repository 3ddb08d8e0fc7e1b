#pragma once

#include <optional>
#include <vector>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/scan_rows.hpp"

namespace sim::surface {

/// Returns the regular grid whose points the table's points match within a tenth of its pitch. The
/// grid may be rotated in its plane. Points that the table lacks become missing points. Returns
/// nothing if the points do not match such a grid, if two of them match the same grid point, or if
/// most points of the grid are missing.
[[nodiscard]] std::optional<GridDraft> lattice_of(const XyzTable& table,
                                                  const std::vector<ScanRow>& rows,
                                                  const std::string& name);

}  // namespace sim::surface

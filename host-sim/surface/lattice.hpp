#pragma once

#include <optional>
#include <vector>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/scan_rows.hpp"

namespace sim::surface {

/// Returns the regular grid, turned in its plane at will, that the points lie on within a tenth of
/// its pitch, with the points that the table lacks as missing ones. Returns nothing where the
/// points do not lie on such a grid, two of them share a place, or most places are missing.
[[nodiscard]] std::optional<GridDraft> lattice_of(const XyzTable& table,
                                                  const std::vector<ScanRow>& rows,
                                                  const std::string& name);

}  // namespace sim::surface

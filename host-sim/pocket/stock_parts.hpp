#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/pocket/wall_ramp.hpp"

namespace sim::pocket {

/// Areas in which the tool may be, and in which it touches stock. Each area has at least one
/// element.
struct StockAreas {
  const OwnedArea& locus;    ///< Area in which the tool's centre may be.
  const OwnedArea& cleared;  ///< Area without stock.
  /// Area in which the tool's centre is while the tool touches no stock.
  const OwnedArea& idle;
};

/// Length by which a part is extended at both ends, as a share of the tool's radius.
inline constexpr double kPartOverlap = 0.25;

/// Options for driving parts of passes.
struct PartOptions {
  double tool_radius_mm = 3.0;
  WallDrive drive;
};

/// Parts of passes that touch stock, at one depth.
struct StockParts : PathRows {
  std::uint32_t parts = 0;  ///< Number of parts. Each part is one row.
};

/// Returns the parts of passes on which the tool touches stock. Each part is extended at both ends,
/// so that it begins and ends on an arc where no stock is. Where no arc fits, a ramp forth and back
/// along the part leads down to it. Parts near each other form a group. In each group, the parts
/// farther from the wall come first. Throws NoPocketPath where a part is too short for a ramp.
/// @param passes passes that clear the pocket; each follows the pass around it
[[nodiscard]] StockParts parts_in_stock(const std::vector<Contour>& passes,
                                        const StockAreas& areas,
                                        const PartOptions& options);

}  // namespace sim::pocket

#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/pocket/wall_ramp.hpp"

namespace sim::pocket {

/// Areas in which the tool may be, and in which it touches stock. Each area has an element.
struct StockAreas {
  const OwnedArea& locus;    ///< Area in which the tool's centre may be.
  const OwnedArea& cleared;  ///< Area without stock.
  /// Area in which the tool's centre is while the tool touches no stock.
  const OwnedArea& idle;
};

/// A part begins this share of the tool's radius earlier, and ends as much later.
inline constexpr double kPartOverlap = 0.25;

/// Options for driving parts of passes.
struct PartOptions {
  double tool_radius_mm = 3.0;
  WallDrive drive;
};

/// Parts of passes that touch stock, at one depth.
struct StockParts : PathRows {
  std::uint32_t parts = 0;  ///< Number of parts; each is a row.
};

/// Returns the parts of passes at which the tool touches stock. Each part is extended a little, so
/// that it begins and ends where no stock is, on an arc that touches it. Where no arc fits, a ramp
/// forth and back along the part leads down to it. Parts near each other form a group. In each
/// group, the parts farther from the wall come first.
/// Throws NoPocketPath where a part is too short for a ramp.
/// @param passes passes that clear the pocket, each after the pass around it
[[nodiscard]] StockParts parts_in_stock(const std::vector<Contour>& passes,
                                        const StockAreas& areas,
                                        const PartOptions& options);

}  // namespace sim::pocket

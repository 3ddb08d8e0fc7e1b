#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/pocket/wall_ramp.hpp"

namespace sim::pocket {

/// Where the tool may be, and where it meets stock. All areas have an element.
struct StockAreas {
  const OwnedArea& locus;    ///< Where its centre may be.
  const OwnedArea& cleared;  ///< Where no stock is.
  const OwnedArea& idle;     ///< Where its centre is when it meets no stock.
};

/// A part begins earlier, and ends later, by this share of the tool's radius.
inline constexpr double kPartOverlap = 0.25;

/// How parts of passes are driven.
struct PartOptions {
  double tool_radius_mm = 3.0;
  WallDrive drive;
};

/// Parts of passes that meet stock, at one depth.
struct StockParts : PathRows {
  std::uint32_t parts = 0;  ///< Each a row.
};

/// Returns the parts of passes at which the tool meets stock. Each part begins and ends where no
/// stock is, a little before and after, on an arc that touches it; where no arc fits, a ramp forth
/// and back along the part leads down to it. Parts are grouped by where they are, and in each group
/// the ones farther from the wall come first.
/// Throws NoPocketPath where a part is too short for a ramp.
/// @param passes that clear the pocket, each after the one around it
[[nodiscard]] StockParts parts_in_stock(const std::vector<Contour>& passes,
                                        const StockAreas& areas,
                                        const PartOptions& options);

}  // namespace sim::pocket

#pragma once

#include <cstdint>
#include <optional>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/pocket/stock_box.hpp"
#include "planner/pocket/pocket_entry.hpp"

namespace sim::pocket {

struct ZigzagOptions {
  double tool_radius_mm = 3.0;
  double stepover_mm = 3.0;     ///< Greatest distance between lines, up to the tool's diameter.
  double turn_radius_mm = 0.3;  ///< Greatest radius of the turns at the ends of lines; 0: corners.
  double depth_mm = 1.0;        ///< Depth of the floor below the top.
  /// Steepest descent of a ramp divided by its length, above 0, at most 1.
  double slope = 0.05;
  bool plunges = false;  ///< Whether the tool plunges straight down instead of using ramps.
  /// The stock, if the area is that around a stock: see with_surroundings().
  std::optional<StockBox> stock{};
};

/// The path of one level.
struct Zigzag : PathRows {
  std::uint32_t lines = 0;
};

/// Clears an area down to one depth by lines along X, driven forth and back, and then by passes
/// along the walls. From line to line the tool follows the wall, with turns of one tangent at both
/// ends. Where the path along the wall is long, a new row begins. A row descends by a ramp along
/// its first line; a pass along a wall descends by a ramp along itself.
///
/// With a stock, lines and passes that touch no stock are left out. A row begins and descends next
/// to the stock, where its first line begins there or where a path along the wall leads from there
/// to the line. Lines are driven from the lowest upwards or from the highest downwards.
///
/// Guarantee: the tool's centre keeps its radius from the boundary (1e-6 mm), and no stock is left
/// that the tool reaches. With a turn radius above 0, elements join with one tangent, except at
/// corners of the passes along the walls.
///
/// Throws std::invalid_argument for options out of range. Throws NoPocketPath where the tool fits
/// nowhere, or where a line or a wall is too short for a ramp. Throws std::runtime_error for
/// contours that cross, and NoOffset.
[[nodiscard]] Zigzag zigzag_path(const cnc::contour::ContourView<double>& area,
                                 const ZigzagOptions& options);

}  // namespace sim::pocket

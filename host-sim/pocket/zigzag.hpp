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
  double depth_mm = 1.0;        ///< Depth of the floor below the top of the stock, mm.
  /// Steepest slope of a ramp: descent divided by length, above 0, at most 1.
  double slope = 0.05;
  bool plunges = false;  ///< Whether the tool plunges straight down instead of using ramps.
  /// Outline of the stock; set only if the area comes from with_surroundings().
  std::optional<StockBox> stock{};
};

/// Zigzag path of one level.
struct Zigzag : PathRows {
  std::uint32_t lines = 0;
};

/// Clears an area down to one depth by lines along X, driven forth and back, and then by passes
/// along the walls. From line to line, the tool follows the wall, with tangent turns at both ends.
/// Where the path along the wall is too long, a new row begins. A row descends by a ramp along its
/// first line. A pass along a wall descends by a ramp along the wall.
///
/// If a stock is given, lines and passes that touch no stock are omitted. A row begins and descends
/// next to the stock if its first line begins there, or if a path along the wall leads from there
/// to the line. Lines are driven in order, from the lowest upwards or from the highest downwards.
///
/// Guarantee: the tool's centre keeps a distance of the tool's radius from the boundary (within
/// 1e-6 mm), and the tool leaves no stock that it reaches. With a turn radius above 0, elements
/// join with one tangent, except at corners of the passes along the walls.
///
/// Throws std::invalid_argument for options out of range. Throws NoPocketPath if the tool fits
/// nowhere, or if a line or a wall is too short for a ramp. Throws std::runtime_error for contours
/// that cross, and NoOffset.
[[nodiscard]] Zigzag zigzag_path(const cnc::contour::ContourView<double>& area,
                                 const ZigzagOptions& options);

}  // namespace sim::pocket

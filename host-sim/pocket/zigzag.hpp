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
  double stepover_mm = 3.0;     ///< Greatest distance of lines, up to the tool's diameter.
  double turn_radius_mm = 0.3;  ///< Of the turns at the ends of lines, at most; 0: corners.
  double depth_mm = 1.0;        ///< Of the floor below the top.
  double slope = 0.05;          ///< Steepest descent over length of a ramp, 0…1 without 0.
  bool plunges = false;         ///< Straight down in place of ramps.
  /// The stock, where the area is what is around it: see with_surroundings().
  std::optional<StockBox> stock{};
};

/// The path of one level.
struct Zigzag : PathRows {
  std::uint32_t lines = 0;
};

/// Clears an area down to one depth by lines along X, driven forth and back, and passes along the
/// walls after them. From line to line the tool goes along the wall, with turns of one tangent at
/// both ends; where that way is long, a new row begins. A row goes down by a ramp along its first
/// line, a pass along a wall by a ramp along itself.
///
/// With a stock, lines and passes that meet none of it are left out. A row begins beside the stock
/// where its first line does, or where a way along the wall leads there from beside it, and goes
/// down there; lines are driven from the lowest one upwards or from the highest one downwards.
///
/// Guarantee: the tool's centre keeps its radius from the boundary (1e-6 mm); stock is left
/// nowhere that the tool reaches. Joints have one tangent, except at corners of the passes along
/// the walls, with a turn radius above 0.
///
/// Throws std::invalid_argument for options out of range, NoPocketPath where the tool fits nowhere
/// or a line or a wall is too short for a ramp, std::runtime_error for contours that cross, and
/// NoOffset.
[[nodiscard]] Zigzag zigzag_path(const cnc::contour::ContourView<double>& area,
                                 const ZigzagOptions& options);

}  // namespace sim::pocket

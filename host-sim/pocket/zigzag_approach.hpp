#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/stock_box.hpp"
#include "host-sim/pocket/zigzag_turn.hpp"

namespace sim::pocket {

/// A path from a point next to the stock to the beginning of a line.
struct ZigzagApproach {
  cnc::WideVec2 from{0.0, 0.0};
  std::vector<WayElement> way;
  double meets_at_x = 0.0;  ///< X at which the path reaches the line, mm.
  double length_mm = 0.0;
};

/// Returns a path to a line that leads upwards along the wall on one side of the area. The path
/// begins at the nearest point next to the stock from which an arc leads to the wall. Returns none
/// if there is no such point, or if the path has corners.
/// @param space areas that include the surroundings of the stock
[[nodiscard]] std::optional<ZigzagApproach> approach_along_wall(const TurnSpace& space,
                                                                const StockBox& stock,
                                                                double tool_radius_mm,
                                                                const Stretch& line,
                                                                double y_mm,
                                                                Side side);

}  // namespace sim::pocket

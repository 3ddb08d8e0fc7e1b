#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/stock_box.hpp"
#include "host-sim/pocket/zigzag_turn.hpp"

namespace sim::pocket {

/// A way from a place beside the stock to the beginning of a line.
struct ZigzagApproach {
  cnc::WideVec2 from{0.0, 0.0};
  std::vector<WayElement> way;
  double meets_at_x = 0.0;  ///< X at which the row meets its first line, mm.
  double length_mm = 0.0;
};

/// Returns a way along the wall on one side of the area upwards to a line, from the nearest place
/// from which the tool gets to the wall by an arc beside the stock. None where there is none, or
/// the way has corners.
/// @param space with what is around the stock
[[nodiscard]] std::optional<ZigzagApproach> approach_along_wall(const TurnSpace& space,
                                                                const StockBox& stock,
                                                                double tool_radius_mm,
                                                                const Stretch& line,
                                                                double y_mm,
                                                                Side side);

}  // namespace sim::pocket

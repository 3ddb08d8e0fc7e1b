#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/boundary_way.hpp"
#include "host-sim/pocket/scan_line.hpp"

namespace sim::pocket {

/// The areas between which the lines of a zigzag turn.
struct TurnSpace {
  /// Where the tool's centre may be, its corners rounded by the radius of turns. Turns follow its
  /// boundary.
  const OwnedArea& rounded;
  /// The same, smaller by the radius: the centres of turns lie on its boundary.
  const OwnedArea& centres;
  double radius_mm = 0.0;
};

/// A stretch of a line, and one of the next line above it.
struct StretchPair {
  Stretch below;
  Stretch above;
  double y_mm = 0.0;     ///< Of the line below.
  double step_mm = 0.0;  ///< To the line above.
};

/// A way from the end of one line to the beginning of the next line above it.
struct ZigzagTurn {
  double leaves_at_x = 0.0;  ///< Of the line below.
  double meets_at_x = 0.0;   ///< Of the line above.
  std::vector<WayElement> way;
};

/// Returns the turn from one stretch to the other, both on one side of the area. None where there
/// is no way along the wall between them that is shorter than the limit.
[[nodiscard]] std::optional<ZigzagTurn> turn_between(const TurnSpace& space,
                                                     const StretchPair& pair,
                                                     Side side,
                                                     double limit_mm);

}  // namespace sim::pocket

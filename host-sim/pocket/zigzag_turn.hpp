#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/boundary_way.hpp"
#include "host-sim/pocket/scan_line.hpp"

namespace sim::pocket {

/// The areas that the turns between the lines of a zigzag require.
struct TurnSpace {
  /// Area in which the tool's centre may be. Its corners are rounded with the radius of turns.
  /// Turns follow the boundary of this area.
  const OwnedArea& rounded;
  /// The area `rounded`, reduced by the radius of turns. The centres of turns are on its boundary.
  const OwnedArea& centres;
  double radius_mm = 0.0;
};

/// A stretch of a line, with a stretch of the next line above it.
struct StretchPair {
  Stretch below;
  Stretch above;
  double y_mm = 0.0;     ///< Y of the line below, mm.
  double step_mm = 0.0;  ///< Distance to the line above, mm.
};

/// A path from the end of one line to the beginning of the next line above.
struct ZigzagTurn {
  double leaves_at_x = 0.0;  ///< X at which the path leaves the line below, mm.
  double meets_at_x = 0.0;   ///< X at which the path reaches the line above, mm.
  std::vector<WayElement> way;
};

/// Returns the turn between the two stretches of a pair, on one side of the area. Returns none if
/// every path along the wall between the stretches is longer than `limit_mm`.
[[nodiscard]] std::optional<ZigzagTurn> turn_between(const TurnSpace& space,
                                                     const StretchPair& pair,
                                                     Side side,
                                                     double limit_mm);

/// An arc between a line and the wall.
struct WallFillet {
  cnc::WideVec2 on_line{0.0, 0.0};
  BoundaryPlace on_wall;
  double bulge = 0.0;  ///< Bulge of the arc if it is driven upwards.
};

/// Returns the arc between a line and the wall on one side of the area. If `leaves_line`, the arc
/// leads upwards from the line to the wall. Otherwise the arc leads from the wall upwards to the
/// line. Returns none if the wall has a corner there, or is too far away.
[[nodiscard]] std::optional<WallFillet> fillet_at(
    const TurnSpace& space, const Stretch& line, double y_mm, Side side, bool leaves_line);

/// Returns whether a path between a line and the wall, or between two lines, is in the area and
/// smooth. A path is smooth if it has one tangent at all joints and at its end, which is on a line.
/// The result may be false because the wall may have corners.
/// @param begin direction of the line before the path; null where there is none
[[nodiscard]] bool is_smooth(const TurnSpace& space,
                             const cnc::WideVec2& from,
                             const cnc::WideVec2& begin,
                             const std::vector<WayElement>& way,
                             Side side);

}  // namespace sim::pocket

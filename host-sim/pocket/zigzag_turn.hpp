#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/boundary_way.hpp"
#include "host-sim/pocket/scan_line.hpp"

namespace sim::pocket {

/// The areas that the turns between the lines of a zigzag need.
struct TurnSpace {
  /// Area in which the tool's centre may be, its corners rounded by the radius of turns. Turns
  /// follow its boundary.
  const OwnedArea& rounded;
  /// The same area, smaller by this radius: the centres of turns lie on its boundary.
  const OwnedArea& centres;
  double radius_mm = 0.0;
};

/// A stretch of a line, and a stretch of the next line above it.
struct StretchPair {
  Stretch below;
  Stretch above;
  double y_mm = 0.0;     ///< Y of the line below.
  double step_mm = 0.0;  ///< Distance to the line above.
};

/// A path from the end of one line to the beginning of the next line above it.
struct ZigzagTurn {
  double leaves_at_x = 0.0;  ///< X at which it leaves the line below.
  double meets_at_x = 0.0;   ///< X at which it meets the line above.
  std::vector<WayElement> way;
};

/// Returns the turn from one stretch to the other, on one side of the area. Returns none where no
/// path along the wall between them is shorter than the limit.
[[nodiscard]] std::optional<ZigzagTurn> turn_between(const TurnSpace& space,
                                                     const StretchPair& pair,
                                                     Side side,
                                                     double limit_mm);

/// An arc between a line and the wall.
struct WallFillet {
  cnc::WideVec2 on_line{0.0, 0.0};
  BoundaryPlace on_wall;
  double bulge = 0.0;  ///< Bulge in the direction of driving, which is upwards.
};

/// Returns the arc between a line and the wall on one side of the area. It leaves the line upwards
/// to the wall, or it reaches the line from below along the wall. Returns none where the wall has a
/// corner there, or is too far away.
[[nodiscard]] std::optional<WallFillet> fillet_at(
    const TurnSpace& space, const Stretch& line, double y_mm, Side side, bool leaves_line);

/// Returns whether a path between a line and the wall, or from one line to another, is in the area
/// and smooth. It is smooth if it has one tangent at all joints and at its end, which is on a line.
/// The wall may have corners, so that this can fail.
/// @param begin direction of the line before the path; null where there is none
[[nodiscard]] bool is_smooth(const TurnSpace& space,
                             const cnc::WideVec2& from,
                             const cnc::WideVec2& begin,
                             const std::vector<WayElement>& way,
                             Side side);

}  // namespace sim::pocket

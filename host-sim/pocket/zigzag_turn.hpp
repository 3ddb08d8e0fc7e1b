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

/// An arc between a line and the wall.
struct WallFillet {
  cnc::WideVec2 on_line{0.0, 0.0};
  BoundaryPlace on_wall;
  double bulge = 0.0;  ///< As driven, upwards.
};

/// Returns the arc that leaves a line upwards to the wall on one side of the area, or reaches it
/// from below along the wall. None where the wall has a corner there, or is too far.
[[nodiscard]] std::optional<WallFillet> fillet_at(
    const TurnSpace& space, const Stretch& line, double y_mm, Side side, bool leaves_line);

/// Returns whether a way between a line and the wall, or from one line to another, is in the area
/// and has one tangent at all joints and at its end, where it is on a line: the wall may have
/// corners.
/// @param begin direction of the line before it; null where there is none
[[nodiscard]] bool is_smooth(const TurnSpace& space,
                             const cnc::WideVec2& from,
                             const cnc::WideVec2& begin,
                             const std::vector<WayElement>& way,
                             Side side);

}  // namespace sim::pocket

#pragma once

#include "planner/base/coordinate.hpp"

namespace cnc::gcode {

/// Returns whether X, Y and Z do not move between two positions.
[[nodiscard]] bool only_rotary_axes_move(const Position& start, const Position& end);

/// Returns the distance along a straight line: of X Y Z in mm or, if X Y Z do not move, of A B C in
/// degrees. The relative error is at most 3e-7.
[[nodiscard]] float straight_length(const Position& start, const Position& end);

}  // namespace cnc::gcode

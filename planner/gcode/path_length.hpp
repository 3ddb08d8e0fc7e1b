#pragma once

#include "planner/base/coordinate.hpp"

namespace cnc::gcode {

/// Whether X, Y and Z stand still between two places.
[[nodiscard]] bool only_rotary_axes_move(const Position& start, const Position& end);

/// Distance in mm of X Y Z along a straight line, or in degrees of A B C when
/// X Y Z stand still. Relative error at most 3e-7.
[[nodiscard]] float straight_length(const Position& start, const Position& end);

}  // namespace cnc::gcode

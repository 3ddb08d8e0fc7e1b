#include "planner/gcode/path_length.hpp"

#include <cmath>

#include "planner/base/axes.hpp"

namespace cnc::gcode {

bool only_rotary_axes_move(const Position& start, const Position& end) {
  for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
    if (start[axis] != end[axis]) return false;
  }
  return true;
}

float straight_length(const Position& start, const Position& end) {
  const bool rotary = only_rotary_axes_move(start, end);
  const std::size_t first = rotary ? kLinearAxisCount : 0;
  float squares = 0.0F;
  for (std::size_t axis = first; axis < first + kLinearAxisCount; ++axis) {
    const float distance = (end[axis] - start[axis]).mm();
    squares += distance * distance;
  }
  return std::sqrt(squares);
}

}  // namespace cnc::gcode

#pragma once

#include <array>
#include <cstddef>

#include "planner/gcode/modal_state.hpp"

namespace cnc::gcode {

/// End of the last G5, from which the next G5 may continue without I and J.
struct CubicExit {
  bool known = false;
  std::array<Coordinate, 2> place{};  ///< X Y, machine coordinates.
  std::array<Coordinate, 2> arm{};    ///< Vector to the first control point of the next G5.
};

/// All state that a line may change, except the stored positions. It is small enough to be copied
/// for each line, so a refused line simply drops its copy.
struct Context {
  ModalState modal{};
  Shift shift{};
  CubicExit cubic_exit{};
  Position position{};  ///< End of the last motion, machine coordinates.
};

/// Returns the sum of G92 offset and tool length on an axis.
[[nodiscard]] inline Coordinate shift_of(const Shift& shift, std::size_t axis) {
  Coordinate sum{};
  if (shift.g92_in_use) sum += shift.g92[axis];
  if (axis == index_of(Axis::kZ)) sum += shift.tool_length;
  return sum;
}

/// Returns the offset from a programmed position to the machine's position.
[[nodiscard]] inline Coordinate work_offset(const Context& context,
                                            const StoredPlaces& places,
                                            std::size_t axis) {
  const Position& origin = places.systems[context.modal.coordinate_system];
  return origin[axis] + shift_of(context.shift, axis);
}

}  // namespace cnc::gcode

#pragma once

#include <array>
#include <cstddef>

#include "planner/gcode/modal_state.hpp"

namespace cnc::gcode {

/// End of the last G5. The next G5 may continue from there without I and J.
struct CubicExit {
  bool known = false;
  std::array<Coordinate, 2> place{};  ///< X and Y of the end, machine coordinates.
  /// Vector from the end to the first control point of a continuing G5.
  std::array<Coordinate, 2> arm{};
};

/// All state that a line may change, except the stored positions. Each line changes a copy, which
/// is dropped if the line is refused. The state is small enough to be copied for each line.
struct Context {
  ModalState modal{};
  Shift shift{};
  CubicExit cubic_exit{};
  Position position{};  ///< Position at the end of the last motion, machine coordinates.
};

/// Returns the sum of the G92 offset and the tool length on an axis.
[[nodiscard]] inline Coordinate shift_of(const Shift& shift, std::size_t axis) {
  Coordinate sum{};
  if (shift.g92_in_use) sum += shift.g92[axis];
  if (axis == index_of(Axis::kZ)) sum += shift.tool_length;
  return sum;
}

/// Returns the work offset of an axis: machine position = programmed position + work offset.
[[nodiscard]] inline Coordinate work_offset(const Context& context,
                                            const StoredPlaces& places,
                                            std::size_t axis) {
  const Position& origin = places.systems[context.modal.coordinate_system];
  return origin[axis] + shift_of(context.shift, axis);
}

}  // namespace cnc::gcode

#pragma once

#include <array>
#include <cstddef>

#include "planner/gcode/modal_state.hpp"

namespace cnc::gcode {

/// How the last G5 ended: the next one may go on from there without I and J.
struct CubicExit {
  bool known = false;
  std::array<Coordinate, 2> place{};  ///< X Y, machine coordinates.
  std::array<Coordinate, 2> arm{};    ///< To the first control point of the next.
};

/// All that a line may change, but for the stored places: small enough to be
/// copied for each line, and so given up whole when the line is refused.
struct Context {
  ModalState modal{};
  Shift shift{};
  CubicExit cubic_exit{};
  Position position{};  ///< Machine coordinates, where the last motion ends.
};

/// What G92 and the tool add to an axis.
[[nodiscard]] inline Coordinate shift_of(const Shift& shift, std::size_t axis) {
  Coordinate sum{};
  if (shift.g92_in_use) sum += shift.g92[axis];
  if (axis == index_of(Axis::kZ)) sum += shift.tool_length;
  return sum;
}

/// What is added to a programmed place to get the machine's.
[[nodiscard]] inline Coordinate work_offset(const Context& context,
                                            const StoredPlaces& places,
                                            std::size_t axis) {
  const Position& origin = places.systems[context.modal.coordinate_system];
  return origin[axis] + shift_of(context.shift, axis);
}

}  // namespace cnc::gcode

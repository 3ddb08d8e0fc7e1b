#pragma once

#include <string_view>

/// Properties of a machine state, which is a word of a status report of Grbl 1.1. A sender decides
/// by them.
namespace sim {

/// Returns whether nothing moves and the controller accepts a new line immediately.
[[nodiscard]] inline bool is_at_rest(std::string_view state) {
  return state.starts_with("Idle") || state.starts_with("Check");
}

/// Returns whether the machine is at rest, because it is held or because its state has no motion
/// that a hold could stop. The states of a tool change and of check mode are included: lines that
/// wait in them can still start motion, as after a hold.
[[nodiscard]] inline bool has_stopped(std::string_view state) {
  return state == "Hold:0" || state.starts_with("Door:0") || state.starts_with("Door:1") ||
         state.starts_with("Alarm") || state.starts_with("Sleep") || state.starts_with("Tool") ||
         is_at_rest(state);
}

/// Returns whether only a reset ends the state. This is so for a homing cycle, which a hold does
/// not end.
[[nodiscard]] inline bool is_ended_by_reset_only(std::string_view state) {
  return state.starts_with("Home");
}

}  // namespace sim

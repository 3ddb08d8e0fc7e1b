#pragma once

#include <string_view>

/// Questions that a sender asks about a machine state, which is a word of a status report of Grbl
/// 1.1.
namespace sim {

/// Returns whether nothing moves and the controller takes a new line at once.
[[nodiscard]] inline bool is_at_rest(std::string_view state) {
  return state.starts_with("Idle") || state.starts_with("Check");
}

/// Returns whether the machine is held and at rest, or has no motion to hold. Lines that wait in a
/// tool change or in check mode can start motion as those of a hold can.
[[nodiscard]] inline bool has_stopped(std::string_view state) {
  return state == "Hold:0" || state.starts_with("Door:0") || state.starts_with("Door:1") ||
         state.starts_with("Alarm") || state.starts_with("Sleep") || state.starts_with("Tool") ||
         is_at_rest(state);
}

/// Returns whether only a reset ends the state: a hold does not end a homing cycle.
[[nodiscard]] inline bool is_ended_by_reset_only(std::string_view state) {
  return state.starts_with("Home");
}

}  // namespace sim

#pragma once

#include <string_view>

/// What the machine states of a status report, in the words of Grbl 1.1, mean for a sender.
namespace sim {

/// Nothing moves, and a new line is taken at once.
[[nodiscard]] inline bool is_at_rest(std::string_view state) {
  return state.starts_with("Idle") || state.starts_with("Check");
}

/// Held at standstill, or nothing to hold. Lines that wait in a tool change or in check mode are no
/// less armed than those of a hold.
[[nodiscard]] inline bool has_stopped(std::string_view state) {
  return state == "Hold:0" || state.starts_with("Door:0") || state.starts_with("Door:1") ||
         state.starts_with("Alarm") || state.starts_with("Sleep") || state.starts_with("Tool") ||
         is_at_rest(state);
}

/// A hold does not end a homing cycle: only a reset does.
[[nodiscard]] inline bool is_ended_by_reset_only(std::string_view state) {
  return state.starts_with("Home");
}

}  // namespace sim

#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "planner/base/contract.hpp"
#include "planner/gcode/action.hpp"

namespace cnc::gcode {

/// Greatest number of actions of one line: eight for S, T, M6, output, spindle, coolant,
/// compensation and offsets, two for both legs of G28 or for a dwell and a motion, and two for a
/// G40 and a stop.
inline constexpr std::size_t kMaxActions = 12;

/// The actions of one line. Each action is filled in the list itself, because an action is large:
/// copying it would take longer than reading its line.
class ActionList {
 public:
  void clear() { size_ = 0; }

  /// Appends an action and returns it. Only its kind is set. @pre the list has fewer than
  /// kMaxActions actions
  Action& append(ActionKind kind) {
    CNC_ASSERT(size_ < kMaxActions);
    Action& action = actions_[size_++];
    action = Action{};
    action.kind = kind;
    return action;
  }

  [[nodiscard]] std::span<const Action> all() const { return std::span{actions_}.first(size_); }

 private:
  std::array<Action, kMaxActions> actions_{};
  std::size_t size_ = 0;
};

}  // namespace cnc::gcode

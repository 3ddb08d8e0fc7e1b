#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "planner/base/contract.hpp"
#include "planner/gcode/action.hpp"

namespace cnc::gcode {

/// The most that one line can ask for: S, T, M6, output, spindle, coolant,
/// compensation, offsets, either two legs of G28 or a dwell and a motion, stop with G40 before it.
inline constexpr std::size_t kMostActions = 12;

/// The actions of one line, filled in place: an action is large, and making it
/// elsewhere only to copy it would cost more than reading its line.
class ActionList {
 public:
  void clear() { size_ = 0; }

  /// Appends an action that has nothing but its kind. @pre fewer than kMostActions so far
  Action& append(ActionKind kind) {
    CNC_ASSERT(size_ < kMostActions);
    Action& action = actions_[size_++];
    action = Action{};
    action.kind = kind;
    return action;
  }

  [[nodiscard]] std::span<const Action> all() const { return std::span{actions_}.first(size_); }

 private:
  std::array<Action, kMostActions> actions_{};
  std::size_t size_ = 0;
};

}  // namespace cnc::gcode

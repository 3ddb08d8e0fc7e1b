#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "planner/base/contract.hpp"
#include "planner/gcode/action.hpp"

namespace cnc::gcode {

/// Greatest number of actions of one line: S, T, M6, output, spindle, coolant, compensation,
/// offsets, either two legs of G28 or a dwell and a motion, and a stop with a G40 before it.
inline constexpr std::size_t kMaxActions = 12;

/// The actions of one line. They are filled in place: an action is large, and to make it elsewhere
/// and copy it would cost more than reading its line.
class ActionList {
 public:
  void clear() { size_ = 0; }

  /// Appends an action of which only the kind is set. @pre fewer than kMaxActions so far
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

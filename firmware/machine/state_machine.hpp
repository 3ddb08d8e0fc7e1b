#pragma once

#include <cstdint>

namespace cnc {

/// Present task of the machine. The states Idle and Run are one mode, kFree: the state is Run if
/// any action or motion is left.
enum class Mode : std::uint8_t {
  kFree,
  kJog,
  kJogEnding,  ///< The machine is slowing down from a cancelled jog.
  kHome,
  kCheck,
  kHold,
  kDoor,
  kTool,
  kSleep,
  kAlarm,
};

/// Event that may change the mode.
enum class Event : std::uint8_t {
  kHold,
  kResume,  ///< Cycle start. After a door: tool and coolant are restored, so the motion continues.
  kDoor,
  kStay,  ///< After a door: tool and coolant are restored, but the operator must resume once more.
  kJog,
  kJogCancel,
  kHome,
  kCheck,
  kTool,
  kSleep,
  kOver,  ///< The jog or the homing cycle has ended.
  kAlarm,
  kReset,
  kUnlock,
};

/// State machine of the modes, as drawn in ARCHITECTURE.md. A table contains the mode to which each
/// event leads. An event that has no row for the present mode has no effect.
class StateMachine {
 public:
  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] bool in(Mode mode) const { return mode_ == mode; }
  [[nodiscard]] bool allows(Event event) const;
  /// Changes the mode by an event. If the event has no effect in the present mode, returns false.
  bool take(Event event);

 private:
  Mode mode_ = Mode::kFree;
};

}  // namespace cnc

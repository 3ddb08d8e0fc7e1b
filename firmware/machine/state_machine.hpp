#pragma once

#include <cstdint>

namespace cnc {

/// Present task of the machine. Idle and Run are one mode: the state is Run if any action or motion
/// is left.
enum class Mode : std::uint8_t {
  kFree,
  kJog,
  kJogEnding,  ///< Cancelled jog that is still slowing down.
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
  kResume,  ///< Cycle start; after a door, the moment when all is restored.
  kDoor,
  kStay,  ///< After a door all is restored, but the operator must confirm.
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

/// The drawing of ARCHITECTURE.md as a table: the mode to which each event leads, and the events
/// without a meaning.
class StateMachine {
 public:
  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] bool in(Mode mode) const { return mode_ == mode; }
  [[nodiscard]] bool allows(Event event) const;
  /// Takes an event. Returns false, and changes nothing, if the event has no meaning in this mode.
  bool take(Event event);

 private:
  Mode mode_ = Mode::kFree;
};

}  // namespace cnc

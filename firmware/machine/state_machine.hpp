#pragma once

#include <cstdint>

namespace cnc {

/// What the machine is engaged in. Idle and Run are one mode: which of them it
/// is follows from whether anything is left to do.
enum class Mode : std::uint8_t {
  kFree,
  kJog,
  kJogEnding,  ///< Cancelled, still slowing down.
  kHome,
  kCheck,
  kHold,
  kDoor,
  kTool,
  kSleep,
  kAlarm,
};

/// What makes it change.
enum class Event : std::uint8_t {
  kHold,
  kResume,  ///< Cycle start; after a door it comes when all is restored.
  kDoor,
  kStay,  ///< After a door all is restored, but the operator is to confirm.
  kJog,
  kJogCancel,
  kHome,
  kCheck,
  kTool,
  kSleep,
  kOver,  ///< The jog or the homing cycle came to its end.
  kAlarm,
  kReset,
  kUnlock,
};

/// The drawing of ARCHITECTURE.md as a table: where an event leads, and where
/// it means nothing.
class StateMachine {
 public:
  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] bool in(Mode mode) const { return mode_ == mode; }
  [[nodiscard]] bool allows(Event event) const;
  /// False where the event means nothing in this mode; it then changes nothing.
  bool take(Event event);

 private:
  Mode mode_ = Mode::kFree;
};

}  // namespace cnc
